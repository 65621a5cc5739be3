#include "image/compare.h"

#include "image/flip.h"
#include "image/formulas.h"
#include "image/heat_map.h"
#include "image/planes.h"
#include "support/errors.h"
#include "support/pictures.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace gg;
using namespace gg::test;
using image::Comparison;
using image::Errors;
using image::Exr;
using image::Image;
using image::Picture;

namespace {

constexpr double rounding = 1e-6; // pictures are floats

Picture picture(const Image& colour, const std::string& name = "a picture") {
  return {.name = name, .colour = colour};
}

Image constant(int width, int height, float r, float g, float b) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    image.values[i] = r;
    image.values[i + 1] = g;
    image.values[i + 2] = b;
  }
  return image;
}

double mean(const Image& image) {
  return std::accumulate(image.values.begin(), image.values.end(), 0.0)
         / static_cast<double>(image.values.size());
}

// Ids of a 12 x 8 picture: object 1 in columns 1 to 5, object 2 in columns 6 to 10, of all rows but
// the first.
std::vector<float> two_objects() {
  std::vector<float> ids;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x)
      ids.push_back(y == 0 || x == 0 || x == 11 ? 0.0f : x < 6 ? 1.0f : 2.0f);
  return ids;
}

} // namespace

TEST(flip, means_equal_those_of_nvidias_evaluator) {
  // flip-evaluator 1.7 at 67 pixels per degree; flip_check.py makes the numbers again.
  constexpr double tolerance = 1e-4; // both work in single precision; 1.1e-5 was found
  for (const auto& [name, expected] : {std::pair{"gradient", 0.204990},
                                       {"checker", 0.482066},
                                       {"noise", 0.116438},
                                       {"colours", 0.945747},
                                       {"bright", 0.121667}}) {
    const Pair pair = formula_pair(name);
    EXPECT_NEAR(mean(image::flip(pair.test, pair.reference)), expected, tolerance) << name;
  }
}

TEST(flip, is_zero_for_equals_and_one_for_black_against_white) {
  const Pair pair = formula_pair("noise");
  for (const float v : image::flip(pair.test, pair.test).values)
    EXPECT_EQ(v, 0.0f);
  const Image black = constant(40, 30, 0.0f, 0.0f, 0.0f),
              white = constant(40, 30, 1.0f, 1.0f, 1.0f);
  // By the definition: 100 of lightness alone, against green to blue as the largest.
  const Image map = image::flip(black, white);
  for (const float v : map.values)
    EXPECT_NEAR(v, map.values[0], rounding);
  EXPECT_NEAR(map.values[0], 0.967, 0.001);
}

TEST(flip, does_not_depend_on_which_is_the_test) {
  const Pair pair = formula_pair("checker");
  EXPECT_TRUE(pictures_agree(image::flip(pair.test, pair.reference),
                             image::flip(pair.reference, pair.test), {.difference = rounding}));
}

TEST(convolve, repeats_the_edges_and_keeps_the_order_of_weights) {
  image::Plane plane(3, 2);
  plane.values = {1.0f, 2.0f, 4.0f, 10.0f, 20.0f, 40.0f};
  EXPECT_EQ(image::convolve(plane, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}).values,
            (std::vector<float>{1.0f, 1.0f, 2.0f, 10.0f, 10.0f, 20.0f}));
  EXPECT_EQ(image::convolve(plane, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}).values,
            (std::vector<float>{10.0f, 20.0f, 40.0f, 10.0f, 20.0f, 40.0f}));
  // Reaching further than the picture.
  const image::Kernel wide(9, 1.0f / 9.0f);
  for (const float v : image::convolve(image::Plane(2, 1), wide, wide).values)
    EXPECT_EQ(v, 0.0f);
}

TEST(compare, numbers_follow_their_definitions) {
  // One channel of one pixel in four is off: by 0.3 where the reference is 0.5.
  Image test = constant(2, 2, 0.5f, 0.2f, 0.1f);
  const Image reference = test;
  test.at(1, 0, 0) = 0.8f;
  const Errors e = image::compare(picture(test), picture(reference)).frame;
  EXPECT_EQ(e.pixels, 4u);
  EXPECT_NEAR(e.relmse, 0.09 / 0.26 / 12.0, rounding);
  EXPECT_NEAR(e.rmse, std::sqrt(0.09 / 12.0), rounding);
  EXPECT_NEAR(e.bias, 0.3 / 12.0, rounding);
  EXPECT_NEAR(e.reference_mean, 0.8 / 3.0, rounding);
  EXPECT_NEAR(e.p99, 0.3, rounding); // the 12th of 12
  const double shown = image::srgb_from_linear(0.8) - image::srgb_from_linear(0.5);
  EXPECT_NEAR(e.psnr, -10.0 * std::log10(shown * shown / 12.0), 1e-4);
  EXPECT_FALSE(e.noise);
}

TEST(compare, the_display_clips_and_linear_light_does_not) {
  const Errors e = image::compare(picture(constant(8, 8, 3.0f, 3.0f, 3.0f)),
                                  picture(constant(8, 8, 2.0f, 2.0f, 2.0f)))
                       .frame;
  EXPECT_NEAR(e.relmse, 1.0 / 4.01, rounding);
  EXPECT_EQ(e.flip, 0.0);
  EXPECT_TRUE(std::isinf(e.psnr));
}

TEST(compare, p99_leaves_out_one_in_a_hundred) {
  Image test(10, 10, 3);
  for (int i = 0; i < 3; ++i)
    test.values[static_cast<std::size_t>(i)] = 9.0f; // 3 of 300
  test.values[50] = 1.0f;
  EXPECT_EQ(image::compare(picture(test), picture(Image(10, 10, 3))).frame.p99, 1.0);
}

TEST(compare, trimmed_relmse_leaves_out_the_worst_percent_of_the_pixels_and_no_more) {
  // Of 250 pixels two are off by 9, three by .3, the others by .1; black, so errors are squares over
  // 0.01.
  Image test = constant(25, 10, 0.1f, 0.1f, 0.1f);
  const auto set = [&](int x, float v) {
    for (int c = 0; c < 3; ++c)
      test.at(x, 4, c) = v;
  };
  for (const int x : {7, 19})
    set(x, 9.0f);
  for (const int x : {2, 3, 24})
    set(x, 0.3f);
  const Picture black = picture(Image(25, 10, 3));
  const Errors e = image::compare(picture(test), black).frame;
  EXPECT_NEAR(e.relmse, (2 * 8100.0 + 3 * 9.0 + 245.0) / 250.0, 1e-4);
  EXPECT_NEAR(e.relmse_trimmed, (3 * 9.0 + 245.0) / 248.0, rounding);
  EXPECT_TRUE(image::outliers_dominate(e));

  set(7, 0.1f);
  set(19, 0.1f);
  const Errors even = image::compare(picture(test), black).frame;
  EXPECT_NEAR(even.relmse_trimmed, (9.0 + 247.0) / 248.0, rounding);
  EXPECT_FALSE(image::outliers_dominate(even));
  // Of fewer than a hundred pixels none is left out.
  const Errors few =
      image::compare(picture(constant(3, 3, 0.1f, 0.2f, 0.3f)), picture(Image(3, 3, 3))).frame;
  EXPECT_EQ(few.relmse_trimmed, few.relmse);
  EXPECT_FALSE(image::outliers_dominate(few));
}

TEST(noise, of_the_trimmed_percent_is_that_of_the_pixels_that_are_left) {
  // The wildest pixel of the reference is the one that is left out.
  Picture reference = picture(Image(10, 10, 3));
  reference.standard_error = constant(10, 10, 0.01f, 0.01f, 0.01f);
  Image test(10, 10, 3);
  for (int c = 0; c < 3; ++c) {
    reference.standard_error->at(6, 2, c) = 5.0f;
    test.at(6, 2, c) = 7.0f;
  }
  const Errors e = image::compare(picture(test), reference).frame;
  ASSERT_TRUE(e.noise);
  EXPECT_NEAR(e.noise->relmse, 25.0 / 0.01 / 100.0 + 0.0099, 1e-4);
  EXPECT_NEAR(e.noise->relmse_trimmed, 0.01, rounding);
  EXPECT_EQ(e.relmse_trimmed, 0.0);
}

TEST(compare, objects_leave_out_the_pixels_that_they_only_touch) {
  const Image black(12, 8, 3);
  Picture reference = picture(black);
  reference.id = two_objects();
  Image test = black;
  test.at(1, 4, 0) = 1.0f; // the object's edge
  test.at(5, 4, 0) = 1.0f; // between the two objects
  test.at(3, 4, 0) = 0.5f;
  const Comparison c = image::compare(picture(test), reference);
  ASSERT_TRUE(c.objects);
  // Columns 2 to 9 and rows 2 to 7: the picture's edge is not an object's.
  EXPECT_EQ(c.objects->pixels, 8u * 6u);
  EXPECT_NEAR(c.objects->rmse, std::sqrt(1.25 / 144.0), rounding);
  EXPECT_EQ(c.by_object.at(1).pixels, 3u * 6u); // columns 2 to 4
  EXPECT_NEAR(c.by_object.at(1).rmse, std::sqrt(0.25 / 54.0), rounding);
  EXPECT_EQ(c.by_object.at(2).rmse, 0.0);
  EXPECT_NEAR(c.frame.rmse, std::sqrt(2.25 / 288.0), rounding);
}

TEST(compare, coverage_decides_where_it_is_known) {
  Picture reference = picture(Image(12, 8, 3));
  reference.id = two_objects();
  reference.coverage.assign(96, 1.0f);
  reference.coverage[4 * 12 + 3] = 0.75f;
  const Comparison c = image::compare(picture(Image(12, 8, 3)), reference);
  EXPECT_EQ(c.by_object.at(1).pixels, 5u * 7u - 1u);
  EXPECT_EQ(c.objects->pixels, 10u * 7u - 1u);
}

TEST(compare, single_objects_can_be_chosen) {
  Picture reference = picture(Image(12, 8, 3), "truth.exr");
  reference.id = two_objects();
  const Picture test = picture(Image(12, 8, 3), "test.exr");
  const Comparison c = image::compare(test, reference, {2});
  EXPECT_EQ(c.by_object.size(), 1u);
  EXPECT_EQ(c.objects->pixels, c.by_object.at(2).pixels);
  EXPECT_TRUE(fails_with(ExitCode::usage, {"truth.exr", "no object 3", "1 to 2"}, [&] {
    image::compare(test, reference, {2, 3});
  }));
  EXPECT_TRUE(fails_with(ExitCode::usage, {"nothing about objects"},
                         [&] { image::compare(test, test, {1}); }));
}

TEST(compare, different_sizes_are_refused_by_name) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"a.exr", "4 x 3", "b.exr", "5 x 3", "--size"}, [] {
    image::compare(picture(Image(4, 3, 3), "a.exr"), picture(Image(5, 3, 3), "b.exr"));
  }));
}

TEST(noise, its_part_of_the_error_is_what_a_perfect_test_measures) {
  // The truth is 0.5 everywhere; the reference has Gaussian noise of known standard error.
  constexpr int side = 128;
  constexpr float sigma = 0.01f;
  const Image truth = constant(side, side, 0.5f, 0.5f, 0.5f);
  std::mt19937 random(5u);
  std::normal_distribution<float> normal(0.0f, sigma);
  Picture reference = picture(truth);
  for (float& v : reference.colour.values)
    v += normal(random);
  reference.standard_error = constant(side, side, sigma, sigma, sigma);

  const Errors perfect = image::compare(picture(truth), reference).frame;
  ASSERT_TRUE(perfect.noise);
  EXPECT_TRUE(perfect.noise->of_reference);
  EXPECT_FALSE(perfect.noise->of_test);
  // Statistics of n = 49152 values: the mean square of a Gaussian has a relative error of
  // sqrt(2 / n) = 0.64 %; four of those.
  EXPECT_NEAR(perfect.noise->rmse / perfect.rmse, 1.0, 0.0128);
  EXPECT_NEAR(perfect.noise->relmse / perfect.relmse, 1.0, 0.0168); // and the noise in r^2, 0.4 %
  EXPECT_LT(std::abs(perfect.bias), 4.0 * perfect.noise->bias);
  EXPECT_NEAR(perfect.noise->bias, sigma / std::sqrt(3.0 * side * side), 1e-9);
  // Chi-square of three degrees of freedom is below 3 in 60.8 % of cases; 0.4 % is one sigma here.
  EXPECT_NEAR(perfect.noise->pixels_within, 0.608, 0.016);
  EXPECT_TRUE(image::noise_dominates(perfect));

  const Errors wrong =
      image::compare(picture(constant(side, side, 0.7f, 0.7f, 0.7f)), reference).frame;
  EXPECT_FALSE(image::noise_dominates(wrong));
  EXPECT_NEAR(wrong.relmse - wrong.noise->relmse, 0.04 / 0.26, 0.01 * 0.04 / 0.26);
}

TEST(noise, both_pictures_count) {
  Picture test = picture(Image(4, 4, 3)), reference = test;
  test.standard_error = constant(4, 4, 0.3f, 0.3f, 0.3f);
  reference.standard_error = constant(4, 4, 0.4f, 0.4f, 0.4f);
  EXPECT_NEAR(image::compare(test, reference).frame.noise->rmse, 0.5, rounding);
}

TEST(load_picture, reads_what_truth_says_beside_the_colour) {
  Exr exr{.width = 2, .height = 1, .channels = {}, .attributes = {{"object.2", "Ball"}}};
  for (const char* name : {"R", "G", "B", "stderr.R", "stderr.G", "stderr.B"})
    exr.channels[name] = {0.5f, 0.25f};
  exr.channels["id"] = {0.0f, 2.0f};
  exr.channels["coverage"] = {0.0f, 1.0f};
  const auto path = scratch_directory() / "truth.exr";
  image::write_exr(path, exr);
  const Picture p = image::load_picture(path);
  EXPECT_EQ(p.standard_error->at(1, 0, 2), 0.25f);
  EXPECT_EQ(p.id, (std::vector<float>{0.0f, 2.0f}));
  EXPECT_EQ(p.coverage[1], 1.0f);
  EXPECT_EQ(p.object_names.at(2), "Ball");
  EXPECT_FALSE(p.display_referred);

  exr.channels["id"][1] = 1.5f;
  image::write_exr(path, exr);
  EXPECT_TRUE(fails_with(ExitCode::input, {"truth.exr, channel id, pixel (1, 0)", "1.5"},
                         [&] { image::load_picture(path); }));
  exr.channels["id"][1] = 1.0f;
  exr.channels["stderr.G"][0] = NAN;
  image::write_exr(path, exr);
  EXPECT_TRUE(fails_with(ExitCode::input, {"channel stderr.G, pixel (0, 0)"},
                         [&] { image::load_picture(path); }));
  exr.channels["B"][1] = INFINITY;
  exr.channels.erase("stderr.G"); // two of three are as good as none
  image::write_exr(path, exr);
  EXPECT_TRUE(fails_with(ExitCode::input, {"truth.exr, pixel (1, 0)", "not finite: 1"},
                         [&] { image::load_picture(path); }));
}

TEST(load_picture, knows_display_referred_files) {
  const auto path = scratch_directory() / "a.png";
  image::write(path, constant(2, 2, 0.5f, 0.5f, 0.5f));
  EXPECT_TRUE(image::load_picture(path).display_referred);
}

TEST(heat_map, lightness_rises_evenly) {
  const auto lightness = [](double t) {
    const auto c = image::heat_colour(t);
    const double y = 0.21263901 * image::linear_from_srgb(c[0])
                     + 0.71516868 * image::linear_from_srgb(c[1])
                     + 0.07219232 * image::linear_from_srgb(c[2]);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : 24389.0 / 27.0 * y;
  };
  for (int i = 0; i <= 100; ++i)
    EXPECT_NEAR(lightness(i / 100.0), 4.0 + 0.92 * i, 0.01) << i;
  EXPECT_EQ(image::heat_colour(-1.0), image::heat_colour(0.0));
  EXPECT_EQ(image::heat_colour(2.0), image::heat_colour(1.0));
}

TEST(heat_map, has_the_values_above_and_the_scale_below) {
  Image values(400, 50, 1);
  values.at(7, 9) = 0.5f;
  values.at(8, 9) = 99.0f;
  const Image map = image::heat_map(values, 1.0, "a title");
  ASSERT_EQ(map.width, 400);
  ASSERT_EQ(map.height, 50 + 72);
  const auto pixel = [&](int x, int y) {
    return std::array{map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)};
  };
  EXPECT_EQ(pixel(7, 9), image::heat_colour(0.5));
  EXPECT_EQ(pixel(8, 9), image::heat_colour(1.0));
  EXPECT_EQ(pixel(0, 0), image::heat_colour(0.0));
  // The bar runs over the whole colour map, and there is writing above and below it.
  EXPECT_EQ(pixel(10, 50 + 30), image::heat_colour(0.0));
  EXPECT_EQ(pixel(389, 50 + 30), image::heat_colour(1.0));
  const auto written = [&](int from, int to) {
    int dark = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < 400; ++x)
        dark += map.at(x, y, 1) < 0.2f;
    return dark;
  };
  EXPECT_GT(written(50, 50 + 26), 100);
  EXPECT_GT(written(50 + 50, 50 + 72), 100);
  // A picture narrower than its legend.
  EXPECT_EQ(image::heat_map(Image(3, 3, 1), 1.0, "\n\xff").width, 320);
}

TEST(heat_map, scales_end_at_round_numbers) {
  Image values(100, 1, 1);
  EXPECT_EQ(image::round_top(values), 1.0);
  std::fill(values.values.begin(), values.values.end(), 0.013f);
  EXPECT_DOUBLE_EQ(image::round_top(values), 0.02);
  values.values[0] = 1000.0f; // one in a hundred
  EXPECT_DOUBLE_EQ(image::round_top(values), 0.02);
  values.values[1] = 700.0f;
  EXPECT_DOUBLE_EQ(image::round_top(values), 1000.0);
}
