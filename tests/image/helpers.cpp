// The helpers that other modules' tests rely on must fail when they should.
#include "image/samples.h"
#include "support/pictures.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace gg;
using namespace gg::test;
using image::Image;

TEST(pictures_agree, counts_pixels_over_the_difference) {
  const Image reference(10, 10, 3);
  Image picture = reference;
  picture.at(3, 4, 1) = 0.5f;
  picture.at(3, 4, 2) = 0.25f;
  picture.at(7, 7, 0) = 0.1f;
  EXPECT_TRUE(pictures_agree(picture, reference, {.difference = 0.5}));
  EXPECT_TRUE(pictures_agree(picture, reference, {.difference = 0.2, .fraction_over = 0.01}));
  EXPECT_FALSE(pictures_agree(picture, reference, {.difference = 0.2}));
  EXPECT_FALSE(pictures_agree(picture, reference, {.difference = 0.05, .fraction_over = 0.01}));
  const PictureDifference found = difference(picture, reference, 0.05);
  EXPECT_EQ(found.largest, 0.5);
  EXPECT_EQ(found.x, 3);
  EXPECT_EQ(found.y, 4);
  EXPECT_DOUBLE_EQ(found.fraction_over, 0.02);
}

TEST(pictures_agree, leaves_three_pictures_when_it_fails) {
  const Image reference = steps(8, 8, 3);
  Image picture = reference;
  picture.at(1, 1, 1) += 0.25f;
  const auto result = pictures_agree(picture, reference, {.difference = 0.1}, "ball");
  ASSERT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find(scratch_directory().string()), std::string::npos);
  for (const char* name : {"ball.exr", "ball-reference.png", "ball-difference.png"})
    EXPECT_TRUE(std::filesystem::exists(scratch_directory() / name)) << name;
  const Image apart = image::read(scratch_directory() / "ball-difference.exr");
  EXPECT_FLOAT_EQ(apart.at(1, 1, 1), 0.25f);
}

TEST(pictures_agree, fails_on_nan_on_size_and_on_channels) {
  const Image reference = steps(4, 4, 3);
  Image picture = reference;
  picture.at(2, 3, 1) = NAN;
  EXPECT_FALSE(pictures_agree(picture, reference, {.difference = 1e9}));
  EXPECT_FALSE(pictures_agree(picture, picture, {.difference = 1e9}));
  EXPECT_FALSE(pictures_agree(steps(4, 5, 3), reference, {.difference = 1e9}));
  EXPECT_FALSE(pictures_agree(steps(4, 4, 4), reference, {.difference = 1e9}));
  EXPECT_FALSE(is_finite(picture));
  EXPECT_TRUE(is_finite(reference));
}
