// Rays through solids of smooth glass, by ray casting: what the search in interior layers has to find.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gg::test {

enum class Fate {
  none,    // the pixel does not show the solid
  leaves,  // by refraction, after some total reflections
  trapped, // more than 8 of them
  leaks    // through a hole of an open mesh
};

struct Walk {
  Fate fate = Fate::none;
  int reflections = 0;
  std::vector<glm::dvec3> met; // where the ray meets the surface from inside
  glm::dvec3 direction{0.0};   // outside, unit
};

// One walk per pixel, through its centre, from the top left. Shading normals bend; a ray that they would
// send to the wrong side of a triangle is bent by the triangle's own. Where bodies overlap, a surface
// inside another body is none.
std::vector<Walk> walk(const scene::Scene& scene, const scene::Camera& camera, int width,
                       int height);

} // namespace gg::test
