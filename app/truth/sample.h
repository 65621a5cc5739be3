// What one path from the camera, with all its branches, has found.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace gg::truth {

struct Sample {
  glm::dvec3 radiance{0.0};
  std::int32_t object = 0; // 1 + instance that the ray met first; 0: none
  double clamped = 0.0;    // what Settings::clamp took from the radiance, mean of RGB
};

} // namespace gg::truth
