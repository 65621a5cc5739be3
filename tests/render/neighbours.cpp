// Neighbours in pictures: what a rough ball reflects of them moves as smoothly as the camera does.
#include "glsl/f64.h"
#include "render/harness.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gg::test::neighbours_test {
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

environment::Map tilted_sky() {
  return environment_of(
      256, [](glm::dvec3 d) { return glm::dvec3(1.0 + 0.8 * d.y, 1.0 + 0.8 * d.x, 1.0); });
}

// What the rough ball at the origin shows to two cameras a degree apart.
void turns_smoothly(const std::function<image::Image(const frame::FrameDesc&)>& draw) {
  const auto drawn = [&](double angle) {
    return draw({.width = size, .height = size, .samples = 1, .camera = orbit(angle)});
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

// What of the light that meets a ball of rough glass is reflected, or leaves where it first meets the far face: paths by visible
// normals of GGX with separable Smith. Directions are local at each face; a ball's chord mirrors its normal, so that the far
// face is met at the angle from the normal at which the near one was left.
double leaves_a_ball(double alpha, double ior, double c) {
  using namespace glsl::f64;
  constexpr int paths = 4000;
  const auto facet = [&](const glm::dvec3& wo, double eta, double u, double v) {
    const glm::dvec3 wm = ggxSampleVisible(wo, glm::dvec2(alpha), glm::dvec2(u, v));
    const double cosine = glm::dot(wo, wm);
    const double passed = cosine > 0.0 ? fresnelTransmittedAt(cosine, eta) : 0.0;
    return std::array<glm::dvec3, 2>{wm, glm::dvec3(cosine, passed, 0.0)};
  };
  double sum = 0.0;
  for (int i = 0; i < paths; ++i) {
    std::array<double, 4> u{}; // Roberts' lattice: powers of the root of x^5 = x + 1
    double step = 1.0;
    for (double& x : u) {
      step /= 1.1673039782614187;
      x = 0.5 + (i + 1) * step;
      x -= std::floor(x);
    }
    const glm::dvec3 wo(std::sqrt(1.0 - c * c), 0.0, c);
    const auto [wm, first] = facet(wo, ior, u[0], u[1]);
    if (!(first.x > 0.0)) continue;
    const glm::dvec3 back = reflectAbout(wo, wm), inside = refractAbout(wo, wm, ior);
    if (back.z > 0.0) sum += (1.0 - first.y) * ggxG1(tilt(back), alpha);
    if (!(inside.z < 0.0)) continue;
    const glm::dvec3 from_within = glm::normalize(glm::dvec3(inside.x, inside.y, -inside.z));
    const auto [far_wm, second] = facet(from_within, 1.0 / ior, u[2], u[3]);
    const glm::dvec3 outside = refractAbout(from_within, far_wm, 1.0 / ior);
    if (second.x > 0.0 && outside.z < 0.0)
      sum += first.y * ggxG1(tilt(inside), alpha) * second.y * ggxG1(tilt(outside), alpha);
  }
  return sum / paths;
}

} // namespace

// The fit's limits (stages/neighbour_passed.glsl) and those of the reflected lobe's albedo (neighbours/proxy_lobe.glsl).
TEST_P(Render, a_mirror_sees_rough_glass_pass_what_paths_do) {
  constexpr double off = 0.09;
  const auto sky = environment_of(64, [](glm::dvec3) { return glm::dvec3(1.0); });
  const glm::dvec3 eye(6.0, 0.0, 4.5);
  const scene::Camera camera = camera_at(glm::vec3(eye));
  for (const float roughness : {0.387298f, 0.591608f, 0.836660f}) { // alpha .15, .35, .7
    scene::Scene scene = ball(glass(roughness));
    add(scene, square(metal(0.0f)),
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -1.5f)),
                   glm::vec3(4.0f, 4.0f, 1.0f)));
    const auto drawn =
        draw(scene, {sky, {.width = size, .height = size, .samples = 1, .camera = camera}});
    int compared = 0;
    for (int y = 0; y < size; y += 3)
      for (int x = 0; x < size; x += 3) {
        const glm::dvec3 d = view_direction(camera, size, size, x, y);
        if (hit_ball(eye, d) || !(d.z < 0.0)) continue;
        const glm::dvec3 mirror = eye + ((-1.5 - eye.z) / d.z) * d;
        const glm::dvec3 seen(d.x, d.y, -d.z);
        const auto hit = hit_ball(mirror, seen);
        if (!hit || std::max(std::abs(mirror.x), std::abs(mirror.y)) > 3.9) continue;
        const double c = glm::dot(*hit, -seen);
        if (c < 0.35) continue;
        const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
        ASSERT_NEAR(drawn.at(x, y, 1), leaves_a_ball(alpha, 1.5, c), off)
            << "alpha " << alpha << " cosine " << c;
        ++compared;
      }
    EXPECT_GT(compared, 15);
  }
}

TEST_P(Render, a_rough_ball_among_others_changes_smoothly_as_the_camera_turns) {
  scene::Scene scene = ball(metal(0.55f)); // all others beside or behind it
  const auto at = [](const glm::vec3& place) { return glm::translate(glm::mat4(1.0f), place); };
  add(scene, ball(metal(0.1f)), at({2.1f, 0.0f, -0.3f}));
  add(scene, ball(dielectric(0.4f)), at({-1.9f, 0.4f, -0.8f}));
  add(scene, ball(glass(0.1f)), at({0.0f, 2.1f, -0.6f}));
  add(scene, box(dielectric(0.5f)), at({-0.6f, -2.1f, -0.3f}));
  turns_smoothly([&](const frame::FrameDesc& desc) { return draw(scene, {tilted_sky(), desc}); });
}

TEST_P(Render, a_rough_ball_over_checks_changes_smoothly_as_the_camera_turns) {
  scene::Scene scene = ball(metal(0.55f));
  add(scene, square(dielectric(0.6f, glm::vec3(1.0f))),
      glm::scale(glm::rotate(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, -1.05f, 0.0f)),
                             static_cast<float>(-90.0 * degree), glm::vec3(1.0f, 0.0f, 0.0f)),
                 glm::vec3(5.0f)));
  constexpr int checks = 16;
  image::Image8 picture{checks, checks, {}};
  for (int i = 0; i < checks * checks; ++i) {
    const auto value = static_cast<std::uint8_t>((i + i / checks) % 2 ? 230 : 25);
    picture.rgba.insert(picture.rgba.end(), {value, value, value, 255});
  }
  scene.images.push_back(std::make_shared<image::Image8>(std::move(picture)));
  scene::Texture texture;
  texture.image = 0;
  scene.textures.push_back(texture);
  scene.materials.back().base_color_map.texture = 0;
  turns_smoothly([&](const frame::FrameDesc& desc) { return draw(scene, {tilted_sky(), desc}); });
}

TEST_P(Render, without_an_environment_bodies_show_what_shines_and_is_lit_beside_them) {
  constexpr double rounding = 1e-4;
  scene::Scene scene = ball(metal(0.4f));
  const auto at = [](const glm::vec3& place) { return glm::translate(glm::mat4(1.0f), place); };
  add(scene, ball(unlit(glm::vec3(2.0f))), at({2.1f, 0.0f, 0.3f}));
  add(scene, ball(dielectric(0.5f)), at({-2.1f, 0.0f, 0.3f}));
  scene.lights.push_back({.kind = scene::LightKind::directional, .intensity = glm::vec3(3.0f)});
  const frame::FrameDesc desc{
      .width = size, .height = size, .samples = 1, .camera = camera_at({0.0f, 0.0f, 8.0f})};
  const auto none = draw(scene, {std::nullopt, desc});
  const auto black =
      draw(scene, {environment_of(64, [](glm::dvec3) { return glm::dvec3(0.0); }), desc});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      ASSERT_NEAR(none.at(x, y, 1), black.at(x, y, 1), rounding) << x << ' ' << y;
  // The sides of the metal that look at the two.
  const int beside = size * 9 / 80; // pixels, three quarters of the ball's radius
  EXPECT_GT(none.at(size / 2 + beside, size / 2, 1), 0.2f);
  EXPECT_GT(none.at(size / 2 - beside, size / 2, 1), 0.02f);
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

} // namespace gg::test::neighbours_test
