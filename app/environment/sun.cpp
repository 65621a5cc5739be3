#include "environment/sun.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::environment {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double reach = 3.0 * pi / 180.0;  // radians: haze about it is sky
constexpr double least_share = 0.2;         // of the irradiance: below that a shadow is hardly seen
constexpr double part_of_peak = 1.0 / 16.0; // radiance that is still the sun's

double luminance(const glm::dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

glm::dvec3 direction_at(const Map& map, int x, int y) {
  const double phi = 2.0 * pi * ((x + 0.5) / map.width - 0.5), theta = pi * (y + 0.5) / map.height;
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

template <class F>
void each_pixel(const Map& map, F f) {
  for (int y = 0; y < map.height; ++y) {
    const double solid_angle = pixel_solid_angle(map.width, map.height, y);
    for (int x = 0; x < map.width; ++x)
      f(direction_at(map, x, y), glm::dvec3(map.at(x, y)), solid_angle);
  }
}

} // namespace

Sun sun_of(const Map& map) {
  Sun none, sun;
  double peak = 0.0;
  each_pixel(map, [&](const glm::dvec3& d, const glm::dvec3& radiance, double) {
    if (luminance(radiance) <= peak) return;
    peak = luminance(radiance);
    sun.direction = d;
  });
  const glm::dvec3 brightest = sun.direction;
  const double cosine = std::cos(reach);
  glm::dvec3 mean(0.0), around(0.0);
  double spread = 0.0, light = 0.0, disc = 0.0, ring = 0.0, all = 0.0;
  each_pixel(map, [&](const glm::dvec3& d, const glm::dvec3& radiance, double solid_angle) {
    all += std::max(glm::dot(d, brightest), 0.0) * luminance(radiance) * solid_angle;
    if (glm::dot(d, brightest) < cosine) return;
    if (luminance(radiance) < part_of_peak * peak) {
      around += radiance * solid_angle;
      ring += solid_angle;
      return;
    }
    const double own = luminance(radiance) * solid_angle;
    sun.irradiance += radiance * solid_angle;
    mean += own * d;
    light += own;
    disc += solid_angle;
  });
  if (!(light > 0.0) || light < least_share * all || !(ring > 0.0)) return none;
  sun.irradiance = glm::max(sun.irradiance - disc / ring * around, glm::dvec3(0.0));
  sun.direction = glm::normalize(mean);
  each_pixel(map, [&](const glm::dvec3& d, const glm::dvec3& radiance, double solid_angle) {
    if (glm::dot(d, brightest) < cosine || luminance(radiance) < part_of_peak * peak) return;
    const glm::dvec3 apart = d - sun.direction;
    spread += 0.5 * glm::dot(apart, apart) * luminance(radiance) * solid_angle;
  });
  sun.sigma = std::sqrt(spread / light);
  return sun;
}

} // namespace gg::environment
