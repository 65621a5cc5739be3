#include "truth/lights.h"

#include <algorithm>
#include <cmath>

namespace gg::truth {

Arrival arrival_from(const scene::Light& light, const glm::dvec3& position) {
  Arrival a;
  const glm::dvec3 axis(light.direction), intensity(light.intensity);
  if (light.kind == scene::LightKind::directional) {
    a.wi = -axis;
    a.irradiance = intensity;
    return a;
  }
  const glm::dvec3 to = glm::dvec3(light.position) - position;
  const double d2 = glm::dot(to, to);
  // At the light itself the law of distance has no value.
  if (!(d2 > 0.0)) return a;
  a.distance = std::sqrt(d2);
  a.wi = to / a.distance;
  // "Range property": 1 - (d / range)^4, from 0 to 1, over d². Without a range the factor is 1.
  const double range = static_cast<double>(light.range);
  const double part = range > 0.0 ? d2 / (range * range) : 0.0;
  a.irradiance = intensity * (std::clamp(1.0 - part * part, 0.0, 1.0) / d2);
  if (light.kind == scene::LightKind::spot) {
    // "Spot light": (cos * scale + offset)², from 0 to 1; the extension divides by at least 0.001
    // so that equal cones make a sharp edge.
    const double outer = std::cos(static_cast<double>(light.outer_cone));
    const double inner = std::cos(static_cast<double>(light.inner_cone));
    const double scale = 1.0 / std::max(0.001, inner - outer);
    const double falloff = std::clamp((glm::dot(axis, -a.wi) - outer) * scale, 0.0, 1.0);
    a.irradiance *= falloff * falloff;
  }
  return a;
}

} // namespace gg::truth
