// How much of what a surface sees is its own body.
#include "needs/hollows.h"

#include "needs/needs.h"
#include "render/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gg::test {
namespace {

needs::Hollows hollows(const scene::Scene& scene) {
  return needs::hollows_of(scene, needs::proxies_of(scene));
}

// The square of shapes.h and one as large above it, which face each other, as one mesh.
scene::Scene facing_squares(float apart) {
  scene::Scene scene = square(dielectric(0.5f));
  scene::Primitive& primitive = scene.meshes[0].primitives[0];
  auto& points = scene.streams[static_cast<std::size_t>(primitive.positions)].values;
  auto& normals = scene.streams[static_cast<std::size_t>(primitive.normals)].values;
  scene::Indices& indices = scene.indices[static_cast<std::size_t>(primitive.indices)];
  const std::size_t corners = points.size() / 3, triangles = indices.size() / 3;
  for (std::size_t i = 0; i < corners; ++i) {
    points.insert(points.end(), {points[3 * i], points[3 * i + 1], apart});
    normals.insert(normals.end(), {0.0f, 0.0f, -1.0f});
  }
  const auto above = static_cast<std::uint32_t>(corners);
  for (std::size_t t = 0; t < triangles; ++t)
    indices.insert(indices.end(), {above + indices[3 * t], above + indices[3 * t + 2],
                                   above + indices[3 * t + 1]});
  primitive.bounds.include(glm::vec3(1.0f, 1.0f, apart));
  return scene;
}

} // namespace

TEST(hollows, what_is_convex_has_none) {
  EXPECT_TRUE(hollows(ball(metal(0.3f))).of.empty());
  EXPECT_TRUE(hollows(box(metal(0.3f))).of.empty());
  EXPECT_TRUE(hollows(square(metal(0.3f))).of.empty());
}

// The form factor of a rectangle from the point under its corner [Howell, C-11], sides a and b over the distance.
TEST(hollows, of_a_square_below_another_are_its_form_factor) {
  const needs::Hollows found = hollows(facing_squares(1.5f));
  ASSERT_EQ(found.streams.size(), 1u);
  const double a = 2.0 / 1.5, side = a / std::sqrt(1.0 + a * a);
  const double factor =
      2.0 * side * std::atan(a / std::sqrt(1.0 + a * a)) / (2.0 * std::numbers::pi);
  for (const float coverage : found.streams[0].values)
    EXPECT_NEAR(static_cast<double>(coverage), factor, 2.0 / needs::hollow_rays) << "rays' steps";
}

TEST(hollows, are_the_same_again) {
  const scene::Scene scene = facing_squares(0.7f);
  EXPECT_EQ(hollows(scene).streams.at(0).values, hollows(scene).streams.at(0).values);
}

TEST(hollows, are_not_asked_for_by_the_standard_method_nor_without_an_environment) {
  const scene::Scene scene = facing_squares(0.7f);
  const auto has = [&](needs::Method method, std::optional<std::size_t> environment) {
    const needs::Needs needs = needs::needs_of(scene, {.camera = camera_at({0, 0, 6}),
                                                       .width = 64,
                                                       .height = 64,
                                                       .method = method,
                                                       .environment = environment});
    return value_of(needs.draws.all.at(0).key, needs::Feature::hollows) != 0;
  };
  EXPECT_TRUE(has(needs::Method::lobes2, 0));
  EXPECT_FALSE(has(needs::Method::standard, 0));
  EXPECT_FALSE(has(needs::Method::lobes2, std::nullopt));
}

} // namespace gg::test
