// Neighbours of draws, as spheres and rectangles.
#include "needs/neighbours.h"

#include "needs/needs.h"
#include "needs/shadow.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gg::test::neighbours_test {
namespace {

using needs::Feature;
using needs::Method;
using needs::Needs;
using needs::Proxy;

constexpr float hull = 0.02f; // of a length: 2,048 points and 21 directions stand for a hull

needs::View view(Method method = Method::lobes2) {
  return {.camera = camera_at({0, 0, 12}),
          .width = 64,
          .height = 64,
          .samples = 1,
          .method = method,
          .environment = 0};
}

glm::mat4 at(const glm::vec3& place) {
  return glm::translate(glm::mat4(1.0f), place);
}

glm::mat4 sized(const glm::vec3& size) {
  return glm::scale(glm::mat4(1.0f), size);
}

int kinds(const Needs& needs, std::size_t draw) {
  return value_of(needs.draws.all[draw].key, Feature::neighbours);
}

} // namespace

TEST(proxies, a_ball_is_a_sphere_of_its_own_size_and_place) {
  scene::Scene scene;
  add(scene, ball(metal(0.3f)), at({1, 2, 3}) * sized(glm::vec3(0.5f)));
  const auto proxies = needs::proxies_of(scene);
  ASSERT_EQ(proxies.all.size(), 1u);
  EXPECT_NEAR(proxies.all[0].radius, 0.5f, 0.5f * hull);
  EXPECT_NEAR(glm::length(proxies.all[0].centre - glm::vec3(1, 2, 3)), 0.0f, 0.5f * hull);
}

TEST(proxies, a_body_has_the_mean_shadow_of_its_hull) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1, 2 * (i >> 1 & 1), 3 * (i >> 2 & 1));
  const double quarter = 2.0 * (1 * 2 + 2 * 3 + 3 * 1) / 4.0; // Cauchy
  const auto shadow = needs::mean_shadow(corners);
  EXPECT_NEAR(shadow.area, quarter, 0.02 * quarter);
  EXPECT_NEAR(glm::length(shadow.centre - glm::dvec3(0.5, 1.0, 1.5)), 0.0, 1e-9);
}

TEST(proxies, of_too_few_points_there_is_no_shadow) {
  EXPECT_EQ(needs::mean_shadow({}).area, 0.0);
  EXPECT_EQ(needs::mean_shadow({{1, 2, 3}, {2, 3, 4}}).area, 0.0);
  EXPECT_EQ(needs::mean_shadow({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).area, 0.0);
}

TEST(proxies, a_long_body_is_several_equal_spheres_along_it) {
  scene::Scene scene;
  add(scene, ball(metal(0.3f)), sized({3.0f, 1.0f, 1.0f}));
  const auto proxies = needs::proxies_of(scene);
  ASSERT_EQ(proxies.all.size(), 3u);
  for (const Proxy& proxy : proxies.all) {
    EXPECT_EQ(proxy.radius, proxies.all[0].radius);
    EXPECT_EQ(proxy.body, proxies.all[0].body);
    EXPECT_NEAR(proxy.centre.y, 0.0f, hull);
  }
  EXPECT_NEAR(std::abs(proxies.all[2].centre.x - proxies.all[0].centre.x), 4.0f, 0.1f);
}

TEST(proxies, a_square_is_a_rectangle_and_a_box_its_six_faces) {
  scene::Scene scene = square(dielectric(0.5f));
  add(scene, box(dielectric(0.5f)), at({5, 0, 0}));
  const auto proxies = needs::proxies_of(scene);
  ASSERT_EQ(proxies.all.size(), 7u);
  EXPECT_NEAR(glm::length(glm::cross(proxies.all[0].side_u, proxies.all[0].side_v)), 1.0f, 1e-5f);
  EXPECT_FALSE(proxies.all[0].one_sided);
  for (std::size_t i = 1; i < 7; ++i) {
    const Proxy& face = proxies.all[i];
    EXPECT_TRUE(face.one_sided);
    EXPECT_EQ(face.radius, 0.0f);
    // It looks away from the middle of the box.
    EXPECT_GT(glm::dot(glm::cross(face.side_u, face.side_v), face.centre - glm::vec3(5, 0, 0)),
              0.9f);
  }
}

TEST(neighbours, a_thing_alone_has_none_and_pays_for_none) {
  for (const scene::Scene& scene :
       {ball(metal(0.3f)), ball(glass(0.1f)), box(dielectric(0.5f)), square(metal(0.1f))}) {
    const Needs needs = needs::needs_of(scene, view());
    EXPECT_TRUE(needs.draws.all[0].neighbours.empty());
    EXPECT_EQ(kinds(needs, 0), 0);
  }
}

TEST(neighbours, are_other_bodies_in_or_out_of_the_picture) {
  scene::Scene scene = ball(metal(0.3f));
  add(scene, ball(glass(0.1f)), at({2.5f, 0, 0}));
  add(scene, square(dielectric(0.5f)), at({0, 0, 30})); // behind the camera
  scene.instances.back().world = at({0, 0, 30}) * sized(glm::vec3(20.0f));
  const Needs needs = needs::needs_of(scene, view());
  ASSERT_EQ(needs.draws.all.size(), 2u);
  EXPECT_EQ(needs.draws.all[0].neighbours.size(), 2u);
  EXPECT_EQ(kinds(needs, 0),
            needs::some_spheres | needs::some_rectangles | needs::some_glass | needs::some_opaque);
  EXPECT_EQ(kinds(needs, 1), needs::some_spheres | needs::some_rectangles | needs::some_opaque)
      << "what glass reflects";
}

TEST(neighbours, are_none_for_the_standard_method_and_for_what_is_unlit) {
  scene::Scene scene = ball(metal(0.3f));
  add(scene, ball(unlit(glm::vec3(1.0f))), at({2.5f, 0, 0}));
  EXPECT_EQ(kinds(needs::needs_of(scene, view(Method::standard)), 0), 0);
  EXPECT_EQ(kinds(needs::needs_of(scene, view()), 0), needs::some_spheres | needs::some_opaque);
  EXPECT_EQ(kinds(needs::needs_of(scene, view()), 1), 0);
}

TEST(neighbours, are_the_eight_that_cover_most) {
  scene::Scene scene = ball(metal(0.3f));
  for (int i = 0; i < 12; ++i)
    add(scene, ball(metal(0.3f)), at({2.5f * static_cast<float>(i + 1), 0, 0}));
  const Needs needs = needs::needs_of(scene, view());
  const auto& list = needs.draws.all[0].neighbours;
  ASSERT_EQ(list.size(), needs::most_neighbours);
  for (std::size_t i = 0; i < list.size(); ++i)
    EXPECT_NEAR(needs.proxies->all[list[i]].centre.x, 2.5f * static_cast<float>(i + 1), 0.1f)
        << "nearest first";
}

TEST(neighbours, a_wall_is_none_of_what_lies_in_its_plane) {
  scene::Scene scene = square(dielectric(0.5f));
  add(scene, square(dielectric(0.5f)), at({2.5f, 0, 0}));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(kinds(needs, 0), 0);
}

TEST(neighbours, split_regions_whose_draws_have_different_ones) {
  scene::Scene scene = ball(metal(0.2f));
  scene.instances.push_back({.mesh = 0, .name = "again"});
  scene.instances.back().world = at({2.5f, 0, 0});
  const Needs near = needs::needs_of(scene, view());
  EXPECT_EQ(near.opaque_regions.size(), 2u);
  scene.instances.back().world = at({0, 0, -200.0f});
  const Needs far = needs::needs_of(scene, view());
  EXPECT_EQ(far.opaque_regions.size(), 1u) << "as far as a neighbour is none";
}

} // namespace gg::test::neighbours_test
