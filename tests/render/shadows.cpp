// Shadow maps of punctual lights against shadows whose outlines are known.
#include "needs/left_out.h"
#include "render/head_on.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace gg::test::shadows_test {
namespace {

constexpr int size = head_on_size;
constexpr double plate_height = 0.3, plate_half = 0.25; // metres, over the square at z = 0
// A texel of the maps here is a 256th of what the plate covers of a view, .6 m at most.
constexpr double texel = 0.6 / 256;

glm::mat4 plate_at(double x, double y) {
  return glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(x, y, plate_height)),
                    glm::vec3(static_cast<float>(plate_half)));
}

scene::Light light(scene::LightKind kind) {
  scene::Light l;
  l.kind = kind;
  l.intensity = glm::vec3(2.0f);
  l.position = {0.35f, 0.25f, 1.1f};
  l.direction = glm::normalize(glm::vec3(-0.4f, -0.2f, -1.0f));
  l.outer_cone = 0.9f;
  return l;
}

// Without the light that lit bodies reflect onto each other.
frame::FrameDesc shadows_alone() {
  frame::FrameDesc desc = head_on();
  desc.without = needs::left_out("neighbours");
  return desc;
}

// Metres on the plate's plane from its outline to where light to the point crosses it; negative within.
double outside_plate(const scene::Light& l, const glm::dvec3& at) {
  const glm::dvec3 to = l.kind == scene::LightKind::directional ? -glm::dvec3(l.direction)
                                                                : glm::dvec3(l.position) - at;
  const glm::dvec3 q = at + to * (plate_height / to.z);
  return std::max(std::abs(q.x), std::abs(q.y)) - plate_half;
}

// What each pixel of the square shows, of what it does without `above`.
class Passed {
public:
  Passed(image::Image lit, image::Image shadowed)
      : lit_(std::move(lit)), shadowed_(std::move(shadowed)) {}
  double at(int x, int y, int channel = 1) const {
    return static_cast<double>(shadowed_.at(x, y, channel))
           / static_cast<double>(lit_.at(x, y, channel));
  }

private:
  image::Image lit_, shadowed_;
};

// The plate hides a part of the square from the camera too: what the camera sees there is left out.
bool camera_sees_square(int x, int y) {
  const glm::dvec3 at = on_square(x, y);
  const glm::dvec3 q = at + (glm::dvec3(0, 0, 2) - at) * (plate_height / 2.0);
  return std::max(std::abs(q.x), std::abs(q.y)) > plate_half + 0.03; // a pixel
}

} // namespace

TEST_P(Render, shadows_end_within_a_texel_of_their_outline) {
  for (const scene::LightKind kind :
       {scene::LightKind::directional, scene::LightKind::point, scene::LightKind::spot}) {
    scene::Scene scene = square(dielectric(1.0f));
    scene.lights = {light(kind)};
    const image::Image lit = draw(scene, {std::nullopt, head_on()});
    add(scene, square(dielectric(1.0f)), plate_at(0, 0));
    const Passed passed(lit, draw(scene, {std::nullopt, head_on()}));
    int shadowed = 0, near = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        if (!camera_sees_square(x, y) || !(lit.at(x, y, 1) > 0.0f)) continue;
        const double outside = outside_plate(scene.lights[0], on_square(x, y));
        const double share = passed.at(x, y);
        if (outside > 3.0 * texel) {
          EXPECT_NEAR(share, 1.0, 1e-5) << x << ' ' << y;
        } else if (outside < -3.0 * texel) {
          EXPECT_NEAR(share, 0.0, 1e-5) << x << ' ' << y;
          ++shadowed;
        } else if (std::abs(outside) > texel) {
          EXPECT_EQ(share > 0.5, outside > 0.0) << x << ' ' << y << ' ' << share;
          ++near;
        }
      }
    EXPECT_GT(shadowed, 15) << static_cast<int>(kind);
    EXPECT_GT(near, 0) << static_cast<int>(kind);
  }
}

TEST_P(Render, a_light_in_the_midst_of_things_casts_all_around) {
  scene::Scene scene = square(dielectric(1.0f));
  scene.lights = {light(scene::LightKind::point)};
  const image::Image lit = draw(scene, {std::nullopt, shadows_alone()});
  add(scene, square(dielectric(1.0f)), plate_at(0, 0));
  // Behind the light and beside it: no one view sees them all. Of these none stands between it and the square.
  for (const glm::vec3& place : {glm::vec3(0.4f, 0.4f, 3.0f), glm::vec3(3.0f, 0.3f, 1.1f)})
    add(scene, ball(dielectric(1.0f)),
        glm::scale(glm::translate(glm::mat4(1.0f), place), glm::vec3(0.3f)));
  const Passed passed(lit, draw(scene, {std::nullopt, shadows_alone()}));
  // A face of 256 texels: at .8 m from the light two are 1.25 cm.
  const double wide = 3.0 * 2.0 * 0.8 / 256;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (!camera_sees_square(x, y)) continue;
      const double outside = outside_plate(scene.lights[0], on_square(x, y));
      if (std::abs(outside) < wide) continue;
      EXPECT_NEAR(passed.at(x, y), outside > 0.0 ? 1.0 : 0.0, 1e-5) << x << ' ' << y;
    }
}

TEST_P(Render, coloured_glass_tints_the_light_that_passes_it) {
  scene::Material pane = glass(0.0f);
  pane.thickness = 0.0f;
  pane.base_color = {0.25f, 0.8f, 0.4f, 1.0f};
  scene::Scene scene = square(dielectric(1.0f));
  scene.lights = {light(scene::LightKind::directional)};
  scene.lights[0].direction = glm::vec3(0, 0, -1);
  const image::Image lit = draw(scene, {std::nullopt, head_on()});
  // Out of the camera's sight, and in the light's: what is drawn is not all that casts.
  scene.lights[0].direction = glm::normalize(glm::vec3(-1.0f, 0.0f, -0.25f));
  const image::Image slanted = draw(scene, {std::nullopt, head_on()});
  add(scene, square(pane), glm::translate(glm::mat4(1.0f), glm::vec3(2.0f, 0.0f, 0.5f)));
  const Passed passed(slanted, draw(scene, {std::nullopt, head_on()}));
  const double cosine = 0.25 / std::sqrt(1.0 + 0.0625), sine2 = 1.0 - cosine * cosine;
  const double inside = std::sqrt(1.0 - sine2 / 2.25); // Snell's law, IOR 1.5
  const double rs = (cosine - 1.5 * inside) / (cosine + 1.5 * inside);
  const double rp = (1.5 * cosine - inside) / (1.5 * cosine + inside);
  const double reflected = 0.5 * (rs * rs + rp * rp);
  const double walls = (1.0 - reflected) / (1.0 + reflected); // all orders between two faces
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(passed.at(size / 2, size / 2, c), walls * static_cast<double>(pane.base_color[c]),
                2e-3);
}

TEST_P(Render, what_is_lit_does_not_shadow_itself) {
  // A grazing light on a floor, a ball on it: all that the ball's shadow does not reach is as bright as alone.
  scene::Scene scene = square(dielectric(1.0f));
  scene.lights = {light(scene::LightKind::directional)};
  for (const float height : {0.15f, 0.5f, 2.0f}) {
    scene::Scene one = scene;
    one.lights[0].direction = glm::normalize(glm::vec3(-1.0f, 0.0f, -height));
    const image::Image lit = draw(one, {std::nullopt, shadows_alone()});
    add(one, ball(dielectric(1.0f)),
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.5f, 0.1f)), glm::vec3(0.1f)));
    const Passed passed(lit, draw(one, {std::nullopt, shadows_alone()}));
    for (int y = size / 2; y < size; ++y) // the half without the ball
      for (int x = 0; x < size; ++x)
        ASSERT_NEAR(passed.at(x, y), 1.0, 1e-5) << x << ' ' << y << ' ' << height;
  }
}

} // namespace gg::test::shadows_test
