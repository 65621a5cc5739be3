// A sun in an environment map: a small part of it that gives much of the light.
#pragma once

#include "environment/map.h"

#include <glm/vec3.hpp>

namespace gg::environment {

struct Sun {
  glm::dvec3 direction{0.0, 1.0, 0.0}; // unit, in the map's frame
  double sigma = 0.0; // radians: the standard deviation per axis of where its light comes from
  glm::dvec3 irradiance{
      0.0}; // across the direction, of what exceeds the sky around it; 0: there is none
};

// The brightest spot of the map, as far as it holds together within 3 degrees, if it gives more than a fifth of the irradiance of a
// surface that faces it.
Sun sun_of(const Map& map);

} // namespace gg::environment
