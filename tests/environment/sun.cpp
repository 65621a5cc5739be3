// Suns in environment maps: found where they are, and only where they cast a shadow that is seen.
#include "environment/sun.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gg::environment::sun_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int width = 2048;
constexpr double pixel = 2.0 * pi / width; // radians
constexpr double outline = 0.05; // of a disc eleven pixels wide: what falls on its outline

// A disc of one radiance in a sky of 1; row 0 is up, the middle column looks along +X.
Map with_disc(const glm::dvec3& towards, double radius, const glm::vec3& radiance) {
  Map map{.name = "disc", .width = width, .height = width / 2};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < width; ++x) {
      const double phi = 2.0 * pi * ((x + 0.5) / width - 0.5), theta = pi * (y + 0.5) / map.height;
      const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                         std::sin(theta) * std::sin(phi));
      const bool inside = glm::length(d - towards) < 2.0 * std::sin(0.5 * radius);
      for (int c = 0; c < 3; ++c)
        map.rgb.push_back(inside ? radiance[c] : 1.0f);
    }
  return map;
}

} // namespace

TEST(sun, of_a_disc_has_its_direction_radius_and_light) {
  constexpr double radius = pi / 180.0;
  const glm::dvec3 radiance(30000.0, 20000.0, 10000.0);
  for (const glm::dvec3& towards : {glm::dvec3(0.3, 0.8, -0.5), glm::dvec3(-1.0, 0.2, 0.01)}) {
    const Sun sun = sun_of(with_disc(glm::normalize(towards), radius, glm::vec3(radiance)));
    EXPECT_LT(glm::length(sun.direction - glm::normalize(towards)), 0.5 * pixel);
    EXPECT_NEAR(sun.sigma, 0.5 * radius, outline * radius); // a disc's deviation per axis
    const double solid_angle = 2.0 * pi * (1.0 - std::cos(radius));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(sun.irradiance[c], (radiance[c] - 1.0) * solid_angle,
                  outline * radiance[c] * solid_angle);
  }
}

TEST(sun, is_none_where_light_is_even) {
  EXPECT_EQ(sun_of(constant(glm::vec3(2.0f))).irradiance, glm::dvec3(0.0));
  EXPECT_EQ(sun_of(constant(glm::vec3(0.0f))).irradiance, glm::dvec3(0.0));
}

TEST(sun, is_none_that_gives_less_than_a_fifth_of_the_light) {
  constexpr double radius = pi / 180.0;
  // A disc's light over that of the sky about it, pi.
  const double per_radiance = 2.0 * (1.0 - std::cos(radius));
  const auto irradiance = [&](double share) {
    const double disc = share / (1.0 - share) / per_radiance;
    return sun_of(with_disc(glm::dvec3(0, 1, 0), radius, glm::vec3(static_cast<float>(disc))))
        .irradiance.x;
  };
  EXPECT_EQ(irradiance(0.15), 0.0);
  EXPECT_GT(irradiance(0.25), 0.0);
}

TEST(sun, is_none_where_a_window_is_bright_and_wide) {
  const Sun sun = sun_of(with_disc(glm::dvec3(0, 1, 0), 30.0 * pi / 180.0, glm::vec3(50.0f)));
  EXPECT_EQ(sun.irradiance, glm::dvec3(0.0));
}

} // namespace gg::environment::sun_test
