#include "core/files.h"
#include "image/image.h"
#include "image/samples.h"
#include "support/errors.h"
#include "support/pictures.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace gg;
using namespace gg::test;
using image::Image;
using image::Image8;

TEST(srgb, both_directions_undo_each_other) {
  for (int i = 0; i <= 255; ++i) {
    const double encoded = i / 255.0;
    // The standard's two pieces meet only to about 1e-8.
    EXPECT_NEAR(image::srgb_from_linear(image::linear_from_srgb(encoded)), encoded, 1e-7);
  }
  EXPECT_EQ(image::srgb_from_linear(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(image::srgb_from_linear(7.0), 1.0);
  EXPECT_NEAR(image::linear_from_srgb(0.5), 0.21404114, 1e-8); // IEC 61966-2-1, by calculator
}

TEST(png, encoded_values_are_rounded_to_the_nearest_of_256) {
  Image image(6, 1, 1);
  image.values = {-1.0f, 0.0f, 0.49f / 255.0f, 0.51f / 255.0f, 1.0f, 9.0f};
  const std::filesystem::path path = scratch_directory() / "picture.png";
  image::write(path, image);
  const std::vector<std::byte> bytes = read_file(path);
  const Image8 back = image::decode(bytes.data(), bytes.size(), "picture.png");
  const int expected[] = {0, 0, 0, 1, 255, 255};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(back.rgba[4 * i], expected[i]) << i;
}

TEST(png, grey_rgb_and_rgba_round_trip_upright) {
  for (const int channels : {1, 3, 4}) {
    const Image image = steps(17, 9, channels);
    const std::filesystem::path path = scratch_directory() / "picture.png";
    image::write(path, image);
    const Image back = image::read(path);
    ASSERT_EQ(back.channels, channels == 4 ? 4 : 3);
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 17; ++x) {
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(back.at(x, y, c),
                      image::linear_from_srgb(image.at(x, y, channels == 1 ? 0 : c)), 1e-7);
        if (channels == 3 || channels == 1) continue;
        ASSERT_EQ(back.at(x, y, 3), image.at(x, y, 3)); // alpha stays as it is
      }
  }
}

TEST(png, the_same_picture_gives_the_same_bytes) {
  const std::filesystem::path a = scratch_directory() / "a.png", b = scratch_directory() / "b.png";
  image::write(a, steps(64, 64, 3));
  image::write(b, steps(64, 64, 3));
  EXPECT_EQ(read_file(a), read_file(b));
}

TEST(write, refuses_what_it_cannot_do_and_leaves_nothing) {
  const Image image = steps(4, 4, 3);
  const std::filesystem::path here = scratch_directory();
  EXPECT_TRUE(
      fails_with(ExitCode::usage, {"x.bmp", ".exr"}, [&] { image::write(here / "x.bmp", image); }));
  EXPECT_TRUE(fails_with(ExitCode::output, {"x.png", "directory"},
                         [&] { image::write("/dev/null/x.png", image); }));
  Image wrong = image;
  wrong.values.pop_back();
  EXPECT_TRUE(
      fails_with(ExitCode::internal, {"x.png"}, [&] { image::write(here / "x.png", wrong); }));
  EXPECT_TRUE(
      fails_with(ExitCode::internal, {"x.exr"}, [&] { image::write(here / "x.exr", Image()); }));
  wrong = image;
  wrong.values[4] = NAN;
  EXPECT_TRUE(fails_with(ExitCode::output, {"x.png", "(1, 0)"},
                         [&] { image::write(here / "x.png", wrong); }));
  EXPECT_TRUE(std::filesystem::is_empty(here));
  EXPECT_TRUE(image::is_writable_extension("a.PNG"));
  EXPECT_TRUE(image::is_writable_extension("dir.x/a.exr"));
  EXPECT_TRUE(image::is_writable_extension("a.jpg"));
  EXPECT_FALSE(image::is_writable_extension("a.tiff"));
  EXPECT_FALSE(image::is_writable_extension("png"));
}

TEST(finiteness, the_first_bad_pixel_and_their_number_are_named) {
  Image image(3, 2, 3);
  EXPECT_FALSE(image::find_non_finite(image));
  EXPECT_NO_THROW(image::require_finite(image, "a.exr"));
  image.at(1, 1, 2) = -INFINITY;
  image.at(2, 1, 0) = NAN;
  image.at(2, 1, 1) = NAN;
  const auto bad = image::find_non_finite(image);
  ASSERT_TRUE(bad);
  EXPECT_EQ(bad->x, 1);
  EXPECT_EQ(bad->y, 1);
  EXPECT_EQ(bad->channel, 2);
  EXPECT_EQ(bad->pixels, 2u);
  EXPECT_TRUE(fails_with(ExitCode::input, {"a.exr, pixel (1, 1)", "finite: 2"},
                         [&] { image::require_finite(image, "a.exr"); }));
}
