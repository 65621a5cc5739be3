// What rays meet, and how it is lit: sides, holes, textures, lights, shadows.
#include "truth/estimate.h"
#include "truth/lights.h"
#include "truth/scenes.h"
#include "truth/textures.h"

#include <numbers>

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;
namespace f64 = gg::glsl::f64;

constexpr double rounding = 4e-6; // see closed_forms.cpp

const Ray from_front{{0.1, 0.05, 5.0}, {0.0, 0.0, -1.0}};
const Ray from_behind{{0.1, 0.05, -5.0}, {0.0, 0.0, 1.0}};

glm::dvec3 seen(const scene::Scene& scene, const Ray& ray, long samples = 100,
                const EnvironmentLight* environment = nullptr) {
  return trace(Integrator(scene, environment, std::nullopt, {}), ray, samples).mean;
}

TEST(truth_sides, single_sided_surfaces_are_not_there_from_behind) {
  scene::Scene scene;
  scene::Material front = unlit(0.25f), both = unlit(0.5f);
  both.double_sided = true;
  add_sheet(scene, front, 1.0f, 0.0f);
  add_sheet(scene, both, 1.0f, 1.0f);
  EXPECT_EQ(seen(scene, from_front).x, 0.5);
  EXPECT_EQ(seen(scene, from_behind).x, 0.5);
  scene.materials[1] = front;
  EXPECT_EQ(seen(scene, from_behind).x, 0.0);
}

TEST(truth_sides, mirrored_instances_show_their_front) {
  scene::Scene scene;
  add_sheet(scene, unlit(0.25f), 1.0f, 0.0f);
  scene.instances[0].world = glm::mat4(1.0f);
  scene.instances[0].world[0][0] = -1.0f;
  scene.instances[0].mirrored = true;
  EXPECT_EQ(seen(scene, from_front).x, 0.25);
  EXPECT_EQ(seen(scene, from_behind).x, 0.0);
}

TEST(truth_holes, masked_surfaces_are_there_or_not_and_blended_ones_partly) {
  scene::Scene scene;
  scene::Material sheet = unlit(0.25f);
  sheet.base_color.w = 0.3f;
  sheet.alpha_mode = scene::AlphaMode::mask;
  add_sheet(scene, unlit(1.0f), 1.0f, -1.0f);
  add_sheet(scene, sheet, 1.0f, 0.0f);
  EXPECT_EQ(seen(scene, from_front).x, 1.0);
  scene.materials[1].alpha_cutoff = 0.2f;
  EXPECT_EQ(seen(scene, from_front).x, 0.25);
  scene.materials[1].alpha_mode = scene::AlphaMode::blend;
  const Estimate blended = trace(Integrator(scene, nullptr, std::nullopt, {}), from_front, 10000);
  EXPECT_TRUE(agrees(blended, glm::dvec3(0.3 * 0.25 + 0.7 * 1.0), rounding));
}

TEST(truth_emission, is_seen_and_lights_others) {
  scene::Scene scene;
  scene::Material lamp{.name = "lamp",
                       .base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
                       .metallic = 0.0f,
                       .emissive = {2.0f, 1.0f, 0.5f}};
  add_sheet(scene, lamp, 1.0f, 0.0f);
  EXPECT_TRUE(agrees(trace(Integrator(scene, nullptr, std::nullopt, {}), from_front, 10),
                     {2.0, 1.0, 0.5}, rounding));
}

// A diffuse sheet seen and lit along its normal has f = (1 - F(0)) albedo / pi + D V F with the
// half-vector along n: D = 1 / (pi alpha²), V = 1/4, F = .04.
double f_at_normal(double albedo, double alpha) {
  constexpr double f0 = 0.04;
  return (1.0 - f0) * albedo / std::numbers::pi + f0 / (4.0 * std::numbers::pi * alpha * alpha);
}

scene::Material plaster() {
  return {.name = "plaster",
          .base_color = {0.5f, 0.5f, 0.5f, 1.0f},
          .metallic = 0.0f,
          .exact_alpha = 1.0f};
}

TEST(truth_lights, follow_the_laws_of_distance_range_and_cone) {
  scene::Scene scene;
  add_sheet(scene, plaster(), 10.0f, 0.0f);
  const double f = f_at_normal(0.5, 1.0);
  const Ray ray{{0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}};
  scene::Light light{.kind = scene::LightKind::point,
                     .intensity = {8.0f, 4.0f, 2.0f},
                     .position = {0.0f, 0.0f, 2.0f}};
  const auto expect = [&](double irradiance, const char* what) {
    scene.lights = {light};
    EXPECT_TRUE(agrees({seen(scene, ray, 4), glm::dvec3(0.0)},
                       f * irradiance * glm::dvec3(8.0, 4.0, 2.0), 8.0 * rounding))
        << what;
  };
  expect(0.25, "point");
  light.range = 4.0f;
  expect(0.25 * (1.0 - 1.0 / 16.0), "point with a range");
  light.kind = scene::LightKind::directional;
  expect(1.0, "directional");
  light.kind = scene::LightKind::spot;
  light.range = INFINITY;
  light.inner_cone = 0.2f;
  light.outer_cone = 0.6f;
  light.direction = glm::normalize(glm::vec3(std::tan(0.4f), 0.0f, -1.0f));
  const double part = (std::cos(0.4) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
  expect(0.25 * part * part, "spot, half-way in its cone");
}

TEST(truth_lights, several_lights_add_up) {
  scene::Scene scene;
  add_sheet(scene, plaster(), 10.0f, 0.0f);
  scene.lights = {{.kind = scene::LightKind::point,
                   .intensity = glm::vec3(8.0f),
                   .position = {0.0f, 0.0f, 2.0f}},
                  {.kind = scene::LightKind::directional, .intensity = {1.0f, 0.0f, 3.0f}}};
  const Estimate both = trace(Integrator(scene, nullptr, std::nullopt, {}),
                              {{0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}}, 20000);
  EXPECT_TRUE(agrees(both, f_at_normal(0.5, 1.0) * glm::dvec3(3.0, 2.0, 5.0), 8.0 * rounding));
}

TEST(truth_lights, cast_shadows_that_holes_walls_and_absorbers_let_through) {
  const auto lit_through = [](scene::Material blocker) {
    scene::Scene scene;
    // So dark that what goes back and forth between it and the blocker is no more than rounding.
    scene::Material soot = plaster();
    soot.base_color = glm::vec4(1e-6f, 1e-6f, 1e-6f, 1.0f);
    add_sheet(scene, soot, 10.0f, 0.0f);
    blocker.double_sided = true;
    if (blocker.thickness > 0.0f)
      add_box(scene, blocker, {0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 0.25f});
    else
      add_sheet(scene, blocker, 1.0f, 1.0f);
    scene.lights = {{.kind = scene::LightKind::point,
                     .intensity = glm::vec3(4.0f),
                     .position = {0.0f, 0.0f, 2.0f}}};
    // Seen from the side, past the blocker: the BSDF is not the one along the normal, so compare
    // with the scene without it.
    const Ray aslant{{3.0, 0.0, 0.5}, glm::normalize(glm::dvec3(-3.0, 0.0, -0.5))};
    const double with = seen(scene, aslant, 4).x;
    scene.instances.pop_back();
    return with / seen(scene, aslant, 4).x;
  };
  scene::Material half = unlit(0.0f);
  half.alpha_mode = scene::AlphaMode::blend;
  half.base_color.w = 0.25f;
  EXPECT_NEAR(lit_through(unlit(0.0f)), 0.0, rounding);
  EXPECT_NEAR(lit_through(half), 0.75, rounding);
  const double f = 0.04;
  EXPECT_NEAR(lit_through(thin_glass(0.0f)), (1.0 - f) / (1.0 + f), rounding);
  scene::Material smoke = glass(0.0f);
  smoke.ior = 1.0f;
  smoke.attenuation_color = glm::vec3(0.25f);
  smoke.attenuation_distance = 1.0f;
  EXPECT_NEAR(lit_through(smoke), 0.5, rounding);
  EXPECT_NEAR(lit_through(glass(0.0f)), 0.0, rounding);
}

TEST(truth_textures, are_bilinear_between_linear_values_and_wrap_as_asked) {
  scene::Scene scene;
  auto image = std::make_shared<image::Image8>();
  image->width = 2;
  image->height = 1;
  image->rgba = {0, 128, 255, 255, 255, 128, 0, 0};
  scene.images = {image};
  scene.textures = {{.image = 0}};
  const scene::Slot slot{.texture = 0};
  const Textures textures(scene);
  constexpr double exact = 1e-12;
  EXPECT_NEAR(textures.at(slot, {0.25, 0.5}, Encoding::srgb).x, 0.0, exact);
  EXPECT_NEAR(textures.at(slot, {0.75, 0.5}, Encoding::srgb).x, 1.0, exact);
  EXPECT_NEAR(textures.at(slot, {0.5, 0.5}, Encoding::srgb).x, 0.5, exact);
  EXPECT_NEAR(textures.at(slot, {0.5, 0.5}, Encoding::srgb).w, 0.5, exact);
  EXPECT_NEAR(textures.at(slot, {0.1, 0.5}, Encoding::srgb).y,
              image::linear_from_srgb(128.0 / 255.0), exact);
  EXPECT_NEAR(textures.at(slot, {0.1, 0.5}, Encoding::linear).y, 128.0 / 255.0, exact);
  // At the seam the two ends meet, or do not.
  EXPECT_NEAR(textures.at(slot, {1.0, 0.5}, Encoding::linear).x, 0.5, exact);
  scene.textures[0].sampler.wrap_s = scene::Wrap::clamp;
  EXPECT_NEAR(textures.at(slot, {1.0, 0.5}, Encoding::linear).x, 1.0, exact);
  scene.textures[0].sampler.wrap_s = scene::Wrap::mirrored_repeat;
  EXPECT_NEAR(textures.at(slot, {1.75, 0.5}, Encoding::linear).x, 0.0, exact);
  EXPECT_NEAR(textures.at(slot, {-0.75, 0.5}, Encoding::linear).x, 1.0, exact);
  scene.textures[0].sampler.magnify = scene::Filter::nearest;
  EXPECT_NEAR(textures.at(slot, {0.45, 0.5}, Encoding::linear).x, 0.0, exact);
}

TEST(truth_normals, the_viewer_is_above_the_surface) {
  const glm::dvec3 wo = glm::normalize(glm::dvec3(1.0, 0.0, 0.2));
  for (const glm::dvec3& n :
       {glm::dvec3(-0.6, 0.0, 0.8), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 0.0)}) {
    const glm::dvec3 turned = face_viewer(n, wo);
    EXPECT_GT(glm::dot(turned, wo), 0.0);
    EXPECT_NEAR(glm::length(turned), 1.0, 1e-12);
    if (glm::dot(n, wo) > 0.0) {
      EXPECT_EQ(turned, n);
    }
  }
}

} // namespace
