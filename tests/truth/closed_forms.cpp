// The path tracer against scenes whose radiance is known on paper.
#include "glsl/f64.h"
#include "truth/estimate.h"
#include "truth/scenes.h"

#include <numbers>

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;
namespace f64 = gg::glsl::f64;

TEST(truth_slab, smooth_absorbing_slab_follows_the_series_of_inner_reflections) {
  scene::Material material = glass(0.0f);
  material.attenuation_color = {0.5f, 0.8f, 1.0f};
  material.attenuation_distance = 0.2f;
  scene::Scene scene;
  const double thickness = 0.1;
  add_box(scene, material, glm::vec3(0.0f, 0.0f, -0.05f), {50.0f, 50.0f, 0.05f});
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  const Integrator integrator = integrator_of(scene, &white);
  for (const double theta : {0.0, 40.0, 75.0}) {
    const double cos_i = std::cos(degrees(theta)), sin_t = std::sin(degrees(theta)) / 1.5;
    const double f = f64::fresnelDielectricAt(cos_i, 1.5);
    const double depth = thickness / std::sqrt(1.0 - sin_t * sin_t) / 0.2;
    glm::dvec3 expected;
    for (int c = 0; c < 3; ++c) {
      const double a = std::pow(static_cast<double>(material.attenuation_color[c]), depth);
      const double through = (1.0 - f) * (1.0 - f) * a / (1.0 - f * f * a * a);
      expected[c] = f + through * (1.0 + f * a);
    }
    EXPECT_TRUE(
        agrees(trace(integrator, towards_origin(degrees(theta)), 20000), expected, rounding))
        << theta << " degrees";
  }
}

TEST(truth_slab, index_one_absorbs_by_the_exponential_of_its_depth) {
  scene::Material material = glass(0.3f);
  material.ior = 1.0f;
  material.attenuation_color = {0.25f, 0.5f, 1.0f};
  material.attenuation_distance = 0.5f;
  scene::Scene scene;
  add_box(scene, material, glm::vec3(0.0f), {1.0f, 1.0f, 0.3f});
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  const Estimate seen =
      trace(integrator_of(scene, &white), {{0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}}, 10);
  const double depth = 0.6 / 0.5;
  EXPECT_TRUE(agrees(seen, {std::pow(0.25, depth), std::pow(0.5, depth), 1.0}, rounding));
}

TEST(truth_wall, smooth_wall_reflects_and_transmits_all_orders_and_tints_once) {
  scene::Material wall = thin_glass(0.0f);
  wall.base_color = {0.5f, 0.9f, 1.0f, 1.0f};
  scene::Material background{
      .name = "background", .base_color = {0.25f, 0.25f, 0.25f, 1.0f}, .unlit = true};
  scene::Scene scene;
  add_sheet(scene, wall, 100.0f, 0.0f);
  add_sheet(scene, background, 100.0f, -1.0f);
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  const Integrator integrator = integrator_of(scene, &white);
  for (const double theta : {0.0, 50.0, 82.0}) {
    const double f = f64::fresnelDielectricAt(std::cos(degrees(theta)), 1.5);
    const double r = 2.0 * f / (1.0 + f), t = (1.0 - f) / (1.0 + f);
    EXPECT_TRUE(agrees(trace(integrator, towards_origin(degrees(theta)), 20000),
                       r + t * 0.25 * glm::dvec3(wall.base_color), rounding))
        << theta << " degrees";
  }
}

TEST(truth_wall, rough_wall_equals_a_solid_slab_of_no_thickness) {
  // The same two interfaces, once walked at one place and once as real surfaces a micrometre apart.
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  scene::Material background{
      .name = "background", .base_color = {0.1f, 0.1f, 0.1f, 1.0f}, .unlit = true};
  scene::Scene thin, solid;
  add_sheet(thin, thin_glass(0.4f), 1000.0f, 0.0f);
  add_box(solid, glass(0.4f), glm::vec3(0.0f, 0.0f, -0.005f), {1000.0f, 1000.0f, 0.005f});
  add_sheet(thin, background, 1000.0f, -0.5f);
  add_sheet(solid, background, 1000.0f, -0.5f);
  const Integrator walls = integrator_of(thin, &white), slabs = integrator_of(solid, &white);
  for (const double theta : {0.0, 70.0}) {
    const Estimate wall = trace(walls, towards_origin(degrees(theta)), 40000, 1);
    const Estimate slab = trace(slabs, towards_origin(degrees(theta)), 40000, 2);
    EXPECT_TRUE(agrees({wall.mean, glm::sqrt(wall.error * wall.error + slab.error * slab.error)},
                       slab.mean, rounding))
        << theta << " degrees";
  }
}

// Colours by direction: 1/2 + d/2 per axis.
glm::dvec3 color_of(const glm::dvec3& d) {
  return 0.5 + 0.5 * d;
}

EnvironmentLight directions_environment() {
  environment::Map map = black_map(512, 256);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const double theta = std::numbers::pi * (y + 0.5) / map.height;
      const double phi = 2.0 * std::numbers::pi * ((x + 0.5) / map.width - 0.5);
      const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                         std::sin(theta) * std::sin(phi));
      for (int c = 0; c < 3; ++c)
        texel(map, x, y)[c] = static_cast<float>(color_of(d)[c]);
    }
  return EnvironmentLight(map, 0.0, 1.0);
}

TEST(truth_ball, smooth_glass_ball_turns_the_world_upside_down_by_snells_law) {
  scene::Scene scene;
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 1.0f, 256);
  const EnvironmentLight world = directions_environment();
  const Integrator integrator = integrator_of(scene, &world);
  // Interpolated normals are off by (pi / 256)² / 8 = 2e-5 rad, magnified by at most some 10 on the
  // way; the map's bilinear steps by (pi / 256)² / 8 too.
  constexpr double facets = 5e-4;
  for (const double b : {0.3, 0.6, 0.9}) {
    const double theta_i = std::asin(b), theta_t = std::asin(b / 1.5);
    const double f = f64::fresnelDielectricAt(std::cos(theta_i), 1.5);
    // Meridional: a ray along -Z at height b. Turned by `angle` towards the axis its direction is
    // (0, -sin, -cos).
    const auto turned = [](double angle) {
      return glm::dvec3(0.0, -std::sin(angle), -std::cos(angle));
    };
    glm::dvec3 expected = f * color_of(turned(std::numbers::pi + 2.0 * theta_i));
    double share = (1.0 - f) * (1.0 - f);
    for (int k = 0; k < 60; ++k, share *= f)
      expected +=
          share
          * color_of(turned(2.0 * (theta_i - theta_t) + k * (std::numbers::pi - 2.0 * theta_t)));
    const Estimate seen = trace(integrator, {{0.0, b, 5.0}, {0.0, 0.0, -1.0}}, 4000);
    EXPECT_TRUE(agrees(seen, expected, facets)) << "height " << b;
    // Upside down: above the centre one sees what is below the horizon.
    if (b < 0.8) {
      EXPECT_LT(seen.mean.y, 0.5) << "height " << b;
    }
  }
}

TEST(truth_media, glass_in_the_same_glass_cannot_be_seen) {
  scene::Material inner = glass(0.2f);
  scene::Scene one, two;
  add_box(one, glass(0.0f), glm::vec3(0.0f), glm::vec3(1.0f));
  add_box(two, glass(0.0f), glm::vec3(0.0f), glm::vec3(1.0f));
  add_ball(two, inner, glm::vec3(0.0f), 0.5f, 16);
  const EnvironmentLight world = directions_environment();
  const Ray ray{{0.2, 0.1, 5.0}, glm::normalize(glm::dvec3(0.05, 0.02, -1.0))};
  const Estimate with = trace(integrator_of(two, &world), ray, 20000, 1);
  const Estimate without = trace(integrator_of(one, &world), ray, 20000, 2);
  EXPECT_TRUE(
      agrees({with.mean, glm::sqrt(with.error * with.error + without.error * without.error)},
             without.mean, rounding));
}

TEST(truth_media, bubble_in_glass_reflects_by_the_ratio_of_the_indices) {
  // Straight through the middle of a box with an air ball: four interfaces at normal incidence,
  // seen against black. The env shines from the back only in the sum of all orders, so look at the
  // furnace instead: it must stay 1.
  scene::Material air_like = glass(0.0f);
  air_like.ior = 1.0f;
  scene::Scene scene;
  add_box(scene, glass(0.0f), glm::vec3(0.0f), glm::vec3(1.0f));
  add_ball(scene, air_like, glm::vec3(0.0f), 0.5f, 64);
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  EXPECT_TRUE(
      agrees(trace(integrator_of(scene, &white), {{0.2, 0.1, 5.0}, {0.0, 0.0, -1.0}}, 20000),
             glm::dvec3(1.0), rounding));
}

TEST(truth_media, eye_inside_glass_sees_radiance_times_the_index_squared) {
  scene::Scene scene;
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 1.0f, 64);
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  const Integrator integrator(scene, &white, glm::dvec3(0.1, 0.0, 0.0), {});
  EXPECT_TRUE(agrees(trace(integrator, {{0.1, 0.0, 0.0}, {0.0, 0.6, -0.8}}, 20000),
                     glm::dvec3(1.5 * 1.5), rounding));
}

} // namespace
