#include "viewer/inspector.h"

#include <gtest/gtest.h>

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
  scene.indices.push_back({0, 1, 2, 0, 2, 3, 6, 5, 4, 7, 6, 4});
  scene.indices.push_back({0, 1, 2, 0, 2, 3});
  for (scene::Index i = 0; i < 2; ++i) {
    scene::Primitive primitive{.positions = 0, .indices = i, .material = i};
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

double integral(const InspectedLobe& lobe, bool fitted) {
  double sum = 0.0;
  for (const LobeValue& value : lobe.exact)
    sum += fitted ? lobe.fit_at(value.angle) : value.value;
  return sum;
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

TEST(inspector, fits_lie_over_the_exact_lobes) {
  // In the plane of incidence the fits take as much light as the exact lobes within a tenth: they are made for pictures, not for
  // one plane.
  constexpr double one_plane = 0.1;
  for (const float alpha : {0.05f, 0.2f, 0.4f}) {
    const auto found = inspect(slab(alpha), ray_at(0.6), needs::Method::lobes2, false);
    ASSERT_TRUE(found);
    for (const InspectedLobe* lobe : {&found->reflected, &found->passes}) {
      ASSERT_FALSE(lobe->fitted.empty());
      EXPECT_NEAR(integral(*lobe, true) / integral(*lobe, false), 1.0, 2.0 * one_plane) << alpha;
    }
    EXPECT_NEAR(found->passes.fitted.front().angle, std::asin(std::sin(0.6) / 1.5), 0.1) << alpha;
  }
}

TEST(inspector, finds_nothing_beside) {
  EXPECT_FALSE(inspect(slab(0.1f), {{0, 0, 5}, {0, 0, 1}}, needs::Method::lobes2, false));
}

} // namespace
} // namespace gg::viewer
