#include "tables/training.h"

#include <glm/gtc/quaternion.hpp>

#include <random>

namespace gg::tables {

std::vector<glm::mat3> random_rotations(int count, unsigned seed) {
  std::mt19937 bits(seed);
  // Not std::normal_distribution, whose values differ between libraries: sums of uniform numbers are normal enough for
  // a direction in four dimensions to be uniform to within a few per cent.
  const auto normal = [&] {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i)
      sum += static_cast<double>(bits()) * 0x1p-32;
    return static_cast<float>(sum);
  };
  std::vector<glm::mat3> list;
  for (int i = 0; i < count; ++i) {
    const float w = normal(), x = normal(), y = normal(), z = normal();
    list.push_back(glm::mat3_cast(glm::normalize(glm::quat(w, x, y, z))));
  }
  return list;
}

Training::Training(std::vector<SphereStack> stacks, int rotations_per_map, unsigned seed)
    : stacks_(std::move(stacks)) {
  const int count = rotations_per_map * static_cast<int>(stacks_.size());
  for (const glm::mat3& rotation : random_rotations(count, seed))
    views_.push_back({static_cast<int>(views_.size()) / rotations_per_map, rotation});
}

} // namespace gg::tables
