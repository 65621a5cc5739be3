// Environments in many orientations.
#pragma once

#include "tables/sphere_map.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace gg::tables {

// `count` rotations from a seed, uniform to within a few per cent, the same on every machine.
std::vector<glm::mat3> random_rotations(int count, unsigned seed);

class Training {
public:
  struct View {
    int stack = 0;
    glm::mat3 world_from_local{1.0f};
  };
  Training(std::vector<SphereStack> stacks, int rotations_per_map, unsigned seed);
  const std::vector<View>& views() const { return views_; }
  const SphereStack& stack(const View& view) const {
    return stacks_[static_cast<std::size_t>(view.stack)];
  }

private:
  std::vector<SphereStack> stacks_;
  std::vector<View> views_;
};

} // namespace gg::tables
