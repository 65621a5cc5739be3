// Neighbours in pictures: what a rough ball reflects of them moves as smoothly as the camera does.
#include "render/harness.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace gg::test::neighbours {
namespace {

constexpr int size = 128;
constexpr double degree = std::numbers::pi / 180.0;
constexpr double largest_jump = 0.05;   // of a pixel's change against its neighbour's
constexpr double from_silhouette = 0.3; // cosine: beyond it the surface itself turns by degrees

scene::Camera orbit(double angle) {
  return camera_at(
      {static_cast<float>(6.0 * std::sin(angle)), 1.5f, static_cast<float>(6.0 * std::cos(angle))});
}

// How much brighter each pixel of the ball at the origin is in the second picture; 0 off the ball.
std::vector<double> changes(const image::Image& a, const image::Image& b,
                            const scene::Camera& camera, const glm::dvec3& eye) {
  std::vector<double> change(static_cast<std::size_t>(size * size), 0.0);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 d = view_direction(camera, size, size, x, y);
      const auto hit = hit_ball(eye, d);
      if (!hit || glm::dot(*hit, -d) < from_silhouette) continue;
      change[static_cast<std::size_t>(y * size + x)] =
          static_cast<double>(b.at(x, y, 1)) / static_cast<double>(a.at(x, y, 1));
    }
  return change;
}

} // namespace

TEST_P(Render, a_rough_ball_among_others_changes_smoothly_as_the_camera_turns) {
  scene::Scene scene = ball(metal(0.55f)); // all others beside or behind it
  const auto at = [](const glm::vec3& place) { return glm::translate(glm::mat4(1.0f), place); };
  add(scene, ball(metal(0.1f)), at({2.1f, 0.0f, -0.3f}));
  add(scene, ball(dielectric(0.4f)), at({-1.9f, 0.4f, -0.8f}));
  add(scene, ball(glass(0.1f)), at({0.0f, 2.1f, -0.6f}));
  add(scene, box(dielectric(0.5f)), at({-0.6f, -2.1f, -0.3f}));
  const auto sky = environment_of(
      256, [](glm::dvec3 d) { return glm::dvec3(1.0 + 0.8 * d.y, 1.0 + 0.8 * d.x, 1.0); });
  const auto drawn = [&](double angle) {
    return draw(scene,
                {sky, {.width = size, .height = size, .samples = 1, .camera = orbit(angle)}});
  };
  const glm::dvec3 eye(0.0, 1.5, 6.0);
  const auto change = changes(drawn(0.0), drawn(degree), orbit(0.0), eye);
  int compared = 0;
  for (int y = 1; y < size; ++y)
    for (int x = 1; x < size; ++x) {
      const auto value = [&](int i, int j) {
        return change[static_cast<std::size_t>(j * size + i)];
      };
      for (const double beside : {value(x - 1, y), value(x, y - 1)}) {
        if (value(x, y) == 0.0 || beside == 0.0) continue;
        ASSERT_NEAR(value(x, y), beside, largest_jump) << x << ' ' << y;
        ++compared;
      }
    }
  EXPECT_GT(compared, 1000);
}

TEST_P(Render, a_lamp_over_a_ball_is_not_seen_through_it_in_the_ball_below) {
  constexpr double dim = 0.1, lamp = 20.0, lamp_cosine = 0.8;
  constexpr double foot = -0.85; // of the upper ball: below, it reflects the top of the lower one
  // The path tracer's mean is .17; with the lamp seen through the upper ball it would be 1.2.
  constexpr double most = 0.5;
  scene::Scene scene = ball(metal(0.1f));
  add(scene, ball(metal(0.4f)), glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, -2.05f, 0.0f)));
  const auto sky =
      environment_of(64, [&](glm::dvec3 d) { return glm::dvec3(d.y > lamp_cosine ? lamp : dim); });
  const scene::Camera camera = camera_at({0.0f, -1.0f, 6.0f});
  const auto drawn =
      draw(scene, {sky, {.width = size, .height = size, .samples = 1, .camera = camera}});
  double sum = 0.0;
  int pixels = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 d = view_direction(camera, size, size, x, y);
      const auto hit = hit_ball({0.0, -1.0, 6.0}, d);
      if (!hit || hit->y > foot) continue;
      sum += static_cast<double>(drawn.at(x, y, 1));
      ++pixels;
    }
  ASSERT_GT(pixels, 20);
  EXPECT_LT(sum / pixels, most);
}

} // namespace gg::test::neighbours
