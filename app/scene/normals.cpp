#include "scene/normals.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gg::scene {
namespace {

glm::vec3 at(std::span<const float> values, std::size_t i) {
  return glm::make_vec3(values.data() + 3 * i);
}

// Twice the area times the normal of a triangle, in double: edges of models measured in millimetres
// square to 1e-6 and their product must not vanish.
glm::dvec3 area_vector(std::span<const float> positions, std::span<const std::uint32_t> corners) {
  const glm::dvec3 a = at(positions, corners[0]), b = at(positions, corners[1]),
                   c = at(positions, corners[2]);
  return glm::cross(b - a, c - a);
}

glm::vec3 unit_or_z(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? glm::vec3(v / length) : glm::vec3(0, 0, 1);
}

} // namespace

std::vector<float> flat_normals(std::span<const float> positions,
                                std::span<const std::uint32_t> indices) {
  std::vector<float> normals;
  normals.reserve(3 * indices.size());
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::vec3 n = unit_or_z(area_vector(positions, indices.subspan(i, 3)));
    for (int corner = 0; corner < 3; ++corner)
      normals.insert(normals.end(), {n.x, n.y, n.z});
  }
  return normals;
}

void mend_zero_normals(std::span<float> normals, std::span<const float> positions,
                       std::span<const std::uint32_t> indices) {
  std::vector<glm::dvec3> sums(normals.size() / 3, glm::dvec3(0));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 area = area_vector(positions, indices.subspan(i, 3));
    for (std::size_t corner = 0; corner < 3; ++corner)
      sums[indices[i + corner]] += area;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (at(normals, i) != glm::vec3(0)) continue;
    const glm::vec3 n = unit_or_z(sums[i]);
    std::copy_n(glm::value_ptr(n), 3, normals.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
}

} // namespace gg::scene
