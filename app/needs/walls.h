// Planar proxies: flat, opaque and large surfaces, which lobes meet beyond the picture too.
#pragma once

#include "needs/draws.h"

#include <glm/glm.hpp>

#include <vector>

namespace gg::needs {

// A rectangle, or what a sheared instance makes of one.
struct Wall {
  glm::vec3 centre;
  glm::vec3 gradient_u,
      gradient_v; // per metre, of where on it a place is: -1 to 1 from edge to edge
  float area;     // m²
};

// As many as the frame's block holds (shaders/interface/frame.glsl).
inline constexpr std::size_t most_walls = 4;

// Of the opaque draws those whose triangles fill a rectangle without holes, the largest first, `most_walls` at most.
std::vector<Wall> walls_of(const scene::Scene& scene, const Draws& draws);

} // namespace gg::needs
