// Where the environment appears, behind things and in them.
#include "render/harness.h"
#include "render/shapes.h"

#include <cmath>
#include <numbers>

namespace gg::test::environment_test {
namespace {

// A map that says its own direction: radiance = (1 + direction) / 2. It is linear in the direction,
// so that filtering between texels moves nothing, and any pixel can be asked which direction it
// shows.
environment::Map directions() {
  return environment_of(1024, [](glm::dvec3 d) { return 0.5 + 0.5 * d; });
}

glm::dvec3 shown(const image::Image& picture, int x, int y) {
  return glm::normalize(2.0 * rgb(picture, x, y) - 1.0);
}

double angle(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

constexpr int size = 256;

// How many pixels away the picture shows what differs by `error`, where one pixel to the right changes it by `across` and
// one down by `along`: least squares.
double displacement(glm::dvec3 error, glm::dvec3 across, glm::dvec3 along) {
  const glm::dmat2 normal(glm::dot(across, across), glm::dot(across, along),
                          glm::dot(across, along), glm::dot(along, along));
  return glm::length(glm::inverse(normal)
                     * glm::dvec2(glm::dot(across, error), glm::dot(along, error)));
}

scene::Scene nothing() {
  scene::Scene scene;
  scene.bounds = {glm::vec3(-1.0f), glm::vec3(1.0f)};
  return scene;
}

frame::FrameDesc small(const scene::Camera& camera) {
  return {.width = size, .height = size, .samples = 1, .camera = camera};
}

} // namespace

TEST_P(Render, a_background_is_seen_and_lights_nothing) {
  frame::FrameDesc desc = small(camera_at({0, 0, 6}));
  const scene::Scene scene = ball(metal(0.3f));
  const image::Image sharp = draw(scene, {directions(), desc});
  desc.background.plain = glm::vec3(0.25f, 0.5f, 2.0f);
  const image::Image plain = draw(scene, {directions(), desc});
  EXPECT_EQ(rgb(plain, 0, 0), glm::dvec3(0.25, 0.5, 2.0));
  EXPECT_EQ(rgb(plain, size / 2, size / 2), rgb(sharp, size / 2, size / 2));
  // A Gaussian on the sphere takes exp(-sigma²) of what is linear in the direction.
  constexpr double sigma = 0.15, interpolation = 0.004; // of cubes, whose texels are a degree there
  desc.background = {.sigma = static_cast<float>(sigma), .plain = {}};
  const image::Image blurred = draw(scene, {directions(), desc});
  EXPECT_EQ(rgb(blurred, size / 2, size / 2), rgb(sharp, size / 2, size / 2));
  for (const int at : {0, 20, size - 1}) {
    EXPECT_NEAR(glm::length(2.0 * rgb(blurred, at, 5) - 1.0), std::exp(-sigma * sigma),
                interpolation);
    EXPECT_LT(angle(shown(blurred, at, 5), shown(sharp, at, 5)), interpolation);
  }
}

TEST_P(Render, sky_shows_each_direction_where_the_camera_looks) {
  const double half_a_pixel =
      0.5 * std::numbers::pi / 4.0 / size; // of the narrowest pixel, in the corners, and then some
  for (const glm::vec3 eye :
       {glm::vec3(4, 0, 0), glm::vec3(-4, 0, 0), glm::vec3(0, 4, 0), glm::vec3(0, -4, 0),
        glm::vec3(0, 0, 4), glm::vec3(0, 0, -4), glm::vec3(2, 3, -1)}) {
    const scene::Camera camera = camera_at(eye);
    const image::Image picture = draw(nothing(), {directions(), small(camera)});
    double worst = 0.0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        worst =
            std::max(worst, angle(shown(picture, x, y), view_direction(camera, size, size, x, y)));
    EXPECT_LT(worst, half_a_pixel) << "from " << eye.x << ", " << eye.y << ", " << eye.z;
  }
}

// The orientation in absolute terms, without the formula that the other tests share with the map:
// row 0 is up, the middle of the picture is +X, three quarters across is +Z.
TEST_P(Render, row_0_of_the_map_is_up_and_its_middle_column_is_plus_x) {
  environment::Map map = environment::constant(glm::vec3(0.0f));
  map.width = 64;
  map.height = 32;
  map.rgb.assign(3 * 64 * 32, 0.0f);
  const auto paint = [&](int x0, int x1, int y0, int y1, int channel) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        map.rgb[static_cast<std::size_t>(3 * (64 * y + x) + channel)] = 1.0f;
  };
  paint(0, 64, 0, 4, 1);    // green around +Y
  paint(28, 36, 12, 20, 0); // red around +X
  paint(44, 52, 12, 20, 2); // blue around +Z
  const auto seen_from = [&](glm::vec3 eye) {
    return rgb(draw(nothing(), {map, small(camera_at(eye))}), size / 2, size / 2);
  };
  EXPECT_NEAR(seen_from({0, -4, 0}).g, 1.0, 1e-3); // looking up
  EXPECT_NEAR(seen_from({-4, 0, 0}).r, 1.0, 1e-3); // looking along +X
  EXPECT_NEAR(seen_from({0, 0, -4}).b, 1.0, 1e-3); // looking along +Z
  EXPECT_NEAR(glm::length(seen_from({0, 4, 0})), 0.0, 1e-3);
  EXPECT_NEAR(glm::length(seen_from({4, 0, 0})), 0.0, 1e-3);
  EXPECT_NEAR(glm::length(seen_from({0, 0, 4})), 0.0, 1e-3);
}

TEST_P(Render, rotating_the_environment_turns_it_counter_clockwise_seen_from_above) {
  const scene::Camera camera = camera_at({1, 0.5f, 4});
  for (const float turn : {0.5f, 2.0f, -1.0f}) {
    frame::FrameDesc desc = small(camera);
    desc.environment.rotation = turn;
    const image::Image picture = draw(nothing(), {directions(), desc});
    const glm::dvec3 d = view_direction(camera, size, size, 100, 60);
    // Counter-clockwise seen from +Y takes +Z to +X. What was at R^-1 d before is at d now.
    const double c = std::cos(turn), s = std::sin(turn);
    const glm::dvec3 before(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
    EXPECT_LT(angle(shown(picture, 100, 60), before), 2e-3) << "turned by " << turn; // half a pixel
  }
}

TEST_P(Render, intensity_scales_the_environment) {
  frame::FrameDesc desc = small(camera_at({0, 0, 4}));
  desc.environment.intensity = 3.0f;
  const image::Image picture =
      draw(ball(metal(0.5f)), {environment::constant({0.25f, 0.5f, 1.0f}), desc});
  const glm::dvec3 sky = rgb(picture, 2, 2);
  EXPECT_NEAR(sky.r, 0.75, 1e-3);
  EXPECT_NEAR(sky.g, 1.5, 2e-3);
  EXPECT_NEAR(sky.b, 3.0, 3e-3);
  const glm::dvec3 on_ball = rgb(picture, size / 2, size / 2);
  EXPECT_NEAR(on_ball.g / on_ball.r, 2.0, 1e-3);
  EXPECT_NEAR(on_ball.b / on_ball.r, 4.0, 2e-3);
}

// Issue: "a mirror ball (alpha 0) shows each coloured direction where the formula puts it, within
// half a pixel".
TEST_P(Render, mirror_ball_shows_each_direction_where_the_law_of_reflection_puts_it) {
  for (const glm::vec3 eye : {glm::vec3(0, 0, 4), glm::vec3(3, 2, -1), glm::vec3(0, -4, 0.5f)}) {
    const scene::Camera camera = camera_at(eye);
    const image::Image picture = draw(ball(metal(0.0f)), {directions(), small(camera)});
    const auto reflected = [&](double x, double y) -> std::optional<glm::dvec3> {
      const glm::dvec3 d = view_direction(camera, size, size, x, y);
      const auto n = hit_ball(glm::dvec3(eye), d);
      if (!n) return std::nullopt;
      return glm::reflect(d, *n);
    };
    int checked = 0;
    double worst = 0.0;
    glm::ivec2 where(0);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto here = reflected(x, y), right = reflected(x + 0.5, y),
                   left = reflected(x - 0.5, y), up = reflected(x, y - 0.5),
                   down = reflected(x, y + 0.5);
        if (!here || !right || !left || !up || !down)
          continue; // the outline: the formula ends inside the pixel
        const double off = displacement(shown(picture, x, y) - *here, *right - *left, *down - *up);
        if (off > worst) worst = off, where = {x, y};
        ++checked;
      }
    EXPECT_LT(worst, 0.5) << "pixels, at " << where.x << ", " << where.y << ", from " << eye.x
                          << ", " << eye.y << ", " << eye.z;
    EXPECT_GT(checked, 15000); // the ball fills most of the picture
  }
}

// One sample of a mirror or a lens that turns by more than the lamp is wide from pixel to pixel must not meet or miss it by chance:
// what the whole picture gets of it is then a matter of luck. Gaussians of the pixel's variance, a pixel apart, sum to 1.9 at
// its centre and to .4 at its corners.
TEST_P(Render, a_lamp_smaller_than_a_pixel_of_a_curved_surface_is_neither_lost_nor_multiplied) {
  const double lamp = std::cos(0.012); // radians; a pixel of the balls turns the ray by .1 and more
  const auto sky = environment_of(1024, [&](glm::dvec3 d) {
    return glm::dvec3(glm::dot(d, glm::normalize(glm::dvec3(0.5, 0.3, 0.8))) > lamp ? 1000.0 : 0.0);
  });
  const auto light = [&](const scene::Scene& scene, int samples, float turn) {
    frame::FrameDesc desc = small(camera_at({0, 0, 4}));
    desc.width = desc.height = 48;
    desc.samples = samples;
    desc.method = frame::Method::lobes2;
    desc.environment.rotation = turn;
    const image::Image picture = draw(scene, {sky, desc});
    double sum = 0.0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        sum += static_cast<double>(picture.at(x, y, 1));
    return sum;
  };
  for (const bool mirror : {true, false}) {
    const scene::Scene scene = ball(mirror ? metal(0.0f) : glass(0.0f));
    for (const float turn : {0.05f, 0.1f}) {
      const double truth = light(scene, 64, turn), one = light(scene, 1, turn);
      EXPECT_GT(one, 0.35 * truth) << (mirror ? "mirror " : "glass ") << turn;
      EXPECT_LT(one, 2.0 * truth) << (mirror ? "mirror " : "glass ") << turn;
    }
  }
}

} // namespace gg::test::environment_test
