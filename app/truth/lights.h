// Punctual lights (KHR_lights_punctual): light that arrives from points and directions.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

namespace gg::truth {

struct Arrival {
  glm::dvec3 wi{0.0, 0.0, 1.0}; // unit, to the light
  double distance = INFINITY;   // metres
  glm::dvec3 irradiance{0.0};   // across wi: lux, or candela / m²
};

Arrival arrival_from(const scene::Light& light, const glm::dvec3& position);

} // namespace gg::truth
