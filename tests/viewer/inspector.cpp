#include "viewer/inspector.h"

#include "tables/lobe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::viewer {
namespace {

constexpr double pi = std::numbers::pi;

// A slab of glass a metre thick, open at its sides, with a wall two metres behind it; seen from +Z.
scene::Scene slab(float alpha) {
  scene::Scene scene;
  scene.materials.resize(2);
  scene.materials[0].transmission = scene.materials[0].thickness = 1.0f;
  scene.materials[0].metallic = 0.0f;
  scene.materials[0].exact_alpha = alpha;
  scene.streams.push_back(
      {3, {-9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0, -9, -9, -1, 9, -9, -1, 9, 9, -1, -9, 9, -1}});
  scene.streams.push_back(
      {3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1}});
  scene.streams.push_back({2, std::vector<float>(16, 0.5f)});
  scene.indices.push_back({0, 1, 2, 0, 2, 3, 6, 5, 4, 7, 6, 4});
  scene.indices.push_back({0, 1, 2, 0, 2, 3});
  for (scene::Index i = 0; i < 2; ++i) {
    scene::Primitive primitive{
        .positions = 0, .normals = 1, .uvs = {2}, .indices = i, .material = i};
    primitive.bounds.include({-9.0f, -9.0f, -1.0f});
    primitive.bounds.include({9.0f, 9.0f, 0.0f});
    scene.meshes.push_back({"", {primitive}});
    scene::Instance instance{.mesh = i};
    instance.world[3].z = i == 0 ? 0.0f : -3.0f;
    scene.instances.push_back(instance);
  }
  scene.bounds.include({-9.0f, -9.0f, -3.0f});
  scene.bounds.include({9.0f, 9.0f, 0.0f});
  return scene;
}

Ray ray_at(double incidence) {
  return {
      {-5.0f * static_cast<float>(std::sin(incidence)), 0.0f,
       5.0f * static_cast<float>(std::cos(incidence))},
      {static_cast<float>(std::sin(incidence)), 0.0f, -static_cast<float>(std::cos(incidence))}};
}

TEST(inspector, says_angle_fresnel_and_where_snell_leads) {
  const double incidence = pi / 6.0, inside = std::asin(0.5 / 1.5);
  const auto found = inspect(slab(0.1f), ray_at(incidence), needs::Method::lobes2, false);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->instance, 0);
  EXPECT_NEAR(found->alpha, 0.1, 1e-6);
  EXPECT_NEAR(found->incidence, incidence, 1e-5);
  // Fresnel's equations by their sines and tangents.
  const double s = std::sin(incidence - inside) / std::sin(incidence + inside),
               p = std::tan(incidence - inside) / std::tan(incidence + inside);
  EXPECT_NEAR(found->fresnel, 0.5 * (s * s + p * p), 1e-6);
  ASSERT_TRUE(found->leaves);
  EXPECT_NEAR(found->leaves->length, 1.0 / std::cos(inside), 1e-4);
  EXPECT_FALSE(found->leaves->reflected);
  EXPECT_EQ(found->leaves->meets, 1);
  EXPECT_NEAR(found->leaves->distance, 2.0 / std::cos(incidence), 0.01);
}

TEST(inspector, fits_have_the_energy_and_the_place_of_the_exact_lobes) {
  // Of the tables: their nodes' spacing (tests/tables).
  constexpr double interpolation = 0.005;
  const tables::Model model;
  for (const float alpha : {0.05f, 0.2f, 0.4f}) {
    const auto found = inspect(slab(alpha), ray_at(0.6), needs::Method::lobes2, false);
    ASSERT_TRUE(found);
    const auto shares =
        tables::interface_shares(model, static_cast<double>(alpha), std::cos(0.6), 1.5, 64);
    EXPECT_NEAR(found->reflected.energy, shares.reflected, interpolation) << alpha;
    EXPECT_NEAR(found->passes.energy, shares.transmitted, interpolation) << alpha;
    for (const InspectedLobe* lobe : {&found->reflected, &found->passes}) {
      ASSERT_FALSE(lobe->fitted.empty());
      const auto brightest = std::ranges::max_element(lobe->exact, {}, &LobeValue::value);
      EXPECT_NEAR(lobe->fitted.front().angle, brightest->angle, lobe->fitted.front().sigma)
          << alpha;
      // And about the height: Gaussians are blunter than GGX's peak.
      EXPECT_GT(lobe->fit_at(brightest->angle), 0.5 * brightest->value) << alpha;
      EXPECT_LT(lobe->fit_at(brightest->angle), 1.2 * brightest->value) << alpha;
    }
  }
}

TEST(inspector, reads_maps_and_names_what_lies_over_the_surface) {
  scene::Scene scene = slab(0.1f);
  scene.images.push_back(std::make_shared<image::Image8>(
      image::Image8{.width = 1, .height = 1, .rgba = {0, 128, 255, 255}}));
  scene.textures.push_back({.image = 0});
  scene::Material& m = scene.materials[0];
  m.exact_alpha.reset();
  m.metallic_roughness_map.texture = 0;
  m.transmission = m.thickness = 0.0f;
  m.clearcoat = 0.7f;
  m.clearcoat_roughness = 0.3f;
  const auto found = inspect(scene, ray_at(0.6), needs::Method::lobes2, false);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha, std::pow(128.0 / 255.0, 2), 1e-6);
  EXPECT_NEAR(found->coat, 0.7, 1e-6);
  EXPECT_NEAR(found->coat_alpha, 0.09, 1e-6);
  EXPECT_FALSE(found->film || found->brushed || found->mixed);
}

TEST(inspector, gives_what_is_unlit_no_lobes) {
  scene::Scene scene = slab(0.1f);
  scene.materials[0].unlit = true;
  const auto found = inspect(scene, ray_at(0.6), needs::Method::lobes2, false);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->unlit && found->reflected.fitted.empty() && found->passes.fitted.empty());
}

TEST(inspector, finds_nothing_beside) {
  EXPECT_FALSE(inspect(slab(0.1f), {{0, 0, 5}, {0, 0, 1}}, needs::Method::lobes2, false));
}

} // namespace
} // namespace gg::viewer
