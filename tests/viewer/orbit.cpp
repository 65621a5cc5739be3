#include "viewer/orbit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::viewer {
namespace {

constexpr float rounding = 1e-4f; // of some float operations on coordinates of a few metres

float distance(const Place& place) {
  return glm::length(place.eye - place.target);
}

TEST(orbit, keeps_target_and_distance) {
  Place place{.eye = {1.0f, 2.0f, 3.0f}, .target = {0.5f, 0.0f, 0.0f}};
  const Place before = place;
  for (int i = 0; i < 50; ++i)
    orbit(place, 0.3f, 0.17f);
  EXPECT_EQ(place.target, before.target);
  EXPECT_NEAR(distance(place), distance(before), rounding);
}

TEST(orbit, stops_short_of_the_poles) {
  Place place;
  orbit(place, 0.0f, 100.0f);
  const glm::vec3 arm = glm::normalize(place.eye - place.target);
  EXPECT_GT(arm.y, 0.999f);
  EXPECT_GT(glm::length(glm::cross(arm, place.up)), 0.005f);
  orbit(place, 0.0f, -100.0f);
  EXPECT_LT(glm::normalize(place.eye - place.target).y, -0.999f);
}

TEST(orbit, a_full_turn_comes_back) {
  Place place{.eye = {1.0f, 2.0f, 3.0f}};
  const glm::vec3 before = place.eye;
  for (int i = 0; i < 8; ++i)
    orbit(place, 0.25f * 3.14159265f, 0.0f);
  EXPECT_NEAR(glm::length(place.eye - before), 0.0f, rounding);
}

TEST(pan, moves_the_target_by_what_the_picture_shows) {
  Place place{.eye = {0.0f, 0.0f, 2.0f}, .fovy = 90.0f}; // 4 m high at the target
  pan(place, {0.25f, 0.5f});
  EXPECT_NEAR(place.target.x, -1.0f, rounding);
  EXPECT_NEAR(place.target.y, 2.0f, rounding);
  EXPECT_NEAR(distance(place), 2.0f, rounding);
}

TEST(dolly, leaves_the_point_under_the_cursor) {
  Place place{.eye = {0.0f, 0.0f, 2.0f}, .fovy = 90.0f};
  dolly(place, 0.5f, {0.25f, -0.25f}, 1.0f); // the point (1, 1, 0)
  EXPECT_NEAR(distance(place), 1.0f, rounding);
  // Still a quarter of the height, now 2 m, from the middle.
  EXPECT_NEAR(1.0f - place.target.x, 0.5f, rounding);
  EXPECT_NEAR(1.0f - place.target.y, 0.5f, rounding);
}

TEST(dolly, never_reaches_the_target) {
  Place place;
  for (int i = 0; i < 1000; ++i)
    dolly(place, 0.5f, {0.0f, 0.0f}, 7.5e-3f);
  EXPECT_GT(distance(place), 0.0f);
  EXPECT_TRUE(std::isfinite(place.eye.z));
}

TEST(frame, holds_the_sphere_around_the_bounds) {
  scene::Bounds bounds;
  bounds.include(glm::vec3(-3.0f, 0.0f, -1.0f));
  bounds.include(glm::vec3(5.0f, 2.0f, 1.0f));
  for (const float aspect : {0.5f, 1.0f, 2.0f}) {
    Place place{.eye = {1.0f, 5.0f, 9.0f}};
    frame(place, bounds, aspect);
    const float half =
        std::atan(std::tan(0.5f * glm::radians(place.fovy)) * std::min(aspect, 1.0f));
    EXPECT_NEAR(std::sin(half) * distance(place), bounds.radius(), rounding);
    EXPECT_EQ(place.target, bounds.centre());
  }
}

TEST(place_of, looks_along_the_camera) {
  scene::Camera camera;
  camera.world[3] = {0.0f, 1.0f, 5.0f, 1.0f};
  scene::Bounds bounds;
  bounds.include(glm::vec3(-1.0f));
  bounds.include(glm::vec3(1.0f));
  const Place place = place_of(camera, bounds);
  EXPECT_EQ(place.eye, glm::vec3(0.0f, 1.0f, 5.0f));
  EXPECT_NEAR(glm::length(place.target - glm::vec3(0.0f, 1.0f, 0.0f)), 0.0f, rounding);
  EXPECT_FLOAT_EQ(place.fovy, 45.0f);
}

} // namespace
} // namespace gg::viewer
