// A picture does not depend on how the work was divided, and knows its own error.
#include "core/error.h"
#include "support/errors.h"
#include "truth/estimate.h"
#include "truth/interrupt.h"
#include "truth/render.h"
#include "truth/scenes.h"

#include <atomic>
#include <csignal>

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;

constexpr int side = 24; // pixels

// Glass, metal and something diffuse, under a sky with an edge.
struct Setting {
  scene::Scene scene;
  EnvironmentLight environment;
  Integrator integrator;
  Camera camera;

  static environment::Map sky() {
    environment::Map map = black_map(16, 8);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 16; ++x)
        for (int c = 0; c < 3; ++c)
          texel(map, x, y)[c] = y < 3 ? 2.0f : 0.2f;
    return map;
  }
  static scene::Scene objects() {
    scene::Scene scene;
    add_ball(scene, glass(0.1f), {-0.5f, 0.0f, 0.0f}, 0.6f, 24);
    add_ball(scene, metal(0.2f), {0.6f, 0.0f, -0.5f}, 0.5f, 24);
    add_sheet(scene, {.name = "wall", .base_color = {0.8f, 0.6f, 0.4f, 1.0f}, .metallic = 0.0f},
              1.0f, -1.2f);
    return scene;
  }
  Setting()
      : scene(objects()), environment(sky(), 0.0, 1.0),
        integrator(scene, &environment, std::nullopt, {}), camera(orthographic(1.2f), side, side) {}
  Film render(RenderDesc desc, const Watch& watch = {}) const {
    Film film(side, side);
    truth::render(integrator, camera, desc, film, watch);
    return film;
  }
};

const Setting& setting() {
  static const Setting shared;
  return shared;
}

TEST(truth_render, is_the_same_for_any_number_of_threads) {
  const image::Exr one = setting().render({.samples = 20, .threads = 1}).to_exr();
  const image::Exr three = setting().render({.samples = 20, .threads = 3}).to_exr();
  EXPECT_EQ(one.channels, three.channels);
  EXPECT_EQ(one.attributes, three.attributes);
}

TEST(truth_render, a_background_is_seen_by_the_camera_alone) {
  const Setting& s = setting();
  const Integrator plain(s.scene, &s.environment, std::nullopt,
                         {.background = {.sigma = 0.0, .plain = glm::dvec3(0.25, 0.5, 4.0)}});
  Film with(side, side);
  truth::render(plain, s.camera, {.samples = 8}, with);
  const Film without = s.render({.samples = 8});
  EXPECT_EQ(with.mean(with.at(0, 0)), glm::dvec3(0.25, 0.5, 4.0));
  int drawn = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (const Pixel& pixel = with.at(x, y); pixel.object > 0) {
        ++drawn;
        EXPECT_EQ(with.mean(pixel), without.mean(without.at(x, y)));
      }
  EXPECT_GT(drawn, 0);
}

TEST(truth_render, another_seed_is_another_picture_of_the_same_thing) {
  const Film a = setting().render({.seed = 1, .samples = 64});
  const Film b = setting().render({.seed = 2, .samples = 64});
  EXPECT_NE(a.to_exr().channels, b.to_exr().channels);
  // The difference over its standard error has mean square 1 where the errors are right. 24 x 24
  // pixels of 3 correlated channels know it to some 10 %; 64 samples estimate an error to 10 %.
  double sum = 0.0;
  long count = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::dvec3 ea = a.standard_error(a.at(x, y)), eb = b.standard_error(b.at(x, y));
      const double variance = ea.y * ea.y + eb.y * eb.y;
      if (!(variance > 0.0)) continue;
      const double off = a.mean(a.at(x, y)).y - b.mean(b.at(x, y)).y;
      sum += off * off / variance;
      ++count;
    }
  EXPECT_NEAR(sum / static_cast<double>(count), 1.0, 0.3);
}

TEST(truth_render, resumed_equals_uninterrupted) {
  const Film whole = setting().render({.samples = 48});
  Film resumed = Film::from_exr(setting().render({.samples = 17}).to_exr(), "half.exr");
  ASSERT_EQ(resumed.samples(), 17);
  render(setting().integrator, setting().camera, {.samples = 48}, resumed);
  // The mean and its error went through float32 once.
  constexpr double rounding = 2e-7;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c) {
        const double value = whole.mean(whole.at(x, y))[c];
        const double error = whole.standard_error(whole.at(x, y))[c];
        EXPECT_NEAR(resumed.mean(resumed.at(x, y))[c], value, rounding * value);
        EXPECT_NEAR(resumed.standard_error(resumed.at(x, y))[c], error,
                    rounding * (value + error) + 1e-3 * rounding);
        EXPECT_EQ(resumed.at(x, y).object, whole.at(x, y).object);
      }
}

TEST(truth_render, clamping_says_what_it_takes) {
  const auto render_with = [](double clamp) {
    const Integrator integrator(setting().scene, &setting().environment, std::nullopt,
                                {.clamp = clamp});
    Film film(side, side);
    render(integrator, setting().camera, {.samples = 16}, film);
    return film;
  };
  const Film whole = render_with(INFINITY), clamped = render_with(0.25);
  EXPECT_EQ(whole.clamped_share(), 0.0);
  EXPECT_GT(clamped.clamped_share(), 0.01);
  // The same paths: with what was taken given back, the same light.
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Pixel &a = whole.at(x, y), &b = clamped.at(x, y);
      const double sum = (a.sum.x + a.sum.y + a.sum.z) / 3.0;
      EXPECT_NEAR((b.sum.x + b.sum.y + b.sum.z) / 3.0 + b.clamped, sum, 1e-12 * sum);
    }
}

TEST(truth_render, stops_when_the_error_is_small_enough) {
  const Film film = setting().render({.samples = 100000, .error = 0.1});
  EXPECT_LE(film.relative_error(), 0.1);
  EXPECT_LT(film.samples(), 100000);
  // Not long after: the error is looked at as the samples grow by a sixteenth.
  EXPECT_GT(film.relative_error(), 0.09);
}

TEST(truth_render, that_is_stopped_keeps_whole_passes) {
  const Film whole = setting().render({.samples = 8});
  std::atomic<long> done{0};
  const Film stopped = setting().render(
      {.samples = 1000}, {.report = [&](const Film& film, double) { done = film.samples(); },
                          .stop = [&] { return done >= 8; }});
  EXPECT_EQ(stopped.samples(), 8);
  EXPECT_EQ(stopped.to_exr().channels, whole.to_exr().channels);
}

TEST(truth_render, an_interrupt_is_a_request) {
  const Interruptible interruptible;
  EXPECT_FALSE(Interruptible::requested());
  std::raise(SIGINT);
  EXPECT_TRUE(Interruptible::requested());
}

TEST(truth_film, names_objects_where_every_sample_met_the_same) {
  const Film film = setting().render({.samples = 16});
  EXPECT_EQ(film.at(side / 2 - 5, side / 2).object, 1); // glass ball
  EXPECT_EQ(film.at(side / 2 + 6, side / 2).object, 2); // metal ball
  EXPECT_EQ(film.at(0, 0).object, 0);                   // sky
  EXPECT_EQ(film.at(side / 2, 3).object, 3);            // sheet behind
}

TEST(truth_film, refuses_what_it_did_not_write) {
  image::Exr exr{.width = 1, .height = 1, .channels = {{"R", {1}}, {"G", {1}}, {"B", {1}}}};
  EXPECT_TRUE(gg::test::fails_with(ExitCode::input, {"photo.exr", "--resume"},
                                   [&] { Film::from_exr(exr, "photo.exr"); }));
}

} // namespace
