// What is in the view, and what is not.
#include "needs/needs.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <random>

namespace gg::test {

TEST(view, nothing_of_what_is_left_out_falls_on_the_picture) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-12.0f, 12.0f), size(0.01f, 6.0f), unit(0.0f, 1.0f);
  const needs::View view{.camera = camera_at({0, 0, 6}), .width = 160, .height = 90, .samples = 1};
  const glm::dmat4 clip = needs::clip_from_world(view);
  int outside = 0;
  for (int i = 0; i < 4000; ++i) {
    scene::Bounds box;
    const glm::vec3 corner(place(random), place(random), place(random));
    box.include(corner);
    box.include(corner + glm::vec3(size(random), size(random), size(random)));
    if (!needs::is_outside(box, clip, view.width, view.height)) continue;
    ++outside;
    for (int k = 0; k < 64; ++k) {
      const glm::vec3 share(unit(random), unit(random), unit(random));
      const glm::dvec4 c = clip * glm::dvec4(glm::mix(box.low, box.high, share), 1.0);
      const bool inside =
          c.w > 0.0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z >= 0.0 && c.z <= c.w;
      ASSERT_FALSE(inside);
    }
  }
  EXPECT_GT(outside, 1000); // the sample is about something
}

TEST(view, leaves_out_what_is_beside_it_and_behind_the_eye) {
  scene::Scene scene = box(metal(0.2f));
  for (const glm::vec3 at : {glm::vec3(50, 0, 0), glm::vec3(0, -50, 0), glm::vec3(0, 0, 20)})
    add(scene, ball(glass(0.2f)), glm::translate(glm::mat4(1.0f), at));
  const needs::View view{.camera = camera_at({0, 0, 6}), .samples = 1, .environment = 0};
  const needs::Needs needs = needs::needs_of(scene, view);
  EXPECT_EQ(needs.draws.all.size(), 1u);
  EXPECT_EQ(needs.draws.outside, 3u);
  EXPECT_TRUE(needs.layers.empty());
}

TEST(view, keeps_what_reaches_over_its_border_and_what_the_eye_is_in) {
  const needs::View view{.camera = camera_at({0, 0, 6}), .samples = 1, .environment = 0};
  const glm::dmat4 clip = needs::clip_from_world(view);
  scene::Bounds over, around;
  over.include({0, 0, 0});
  over.include({100, 1, 1});
  around.include(glm::vec3(-100));
  around.include(glm::vec3(100));
  EXPECT_FALSE(needs::is_outside(over, clip, view.width, view.height));
  EXPECT_FALSE(needs::is_outside(around, clip, view.width, view.height));
}

} // namespace gg::test
