// Do two pictures agree? For tests of any module that makes pictures.
#pragma once

#include "image/image.h"

#include <gtest/gtest.h>

#include <string>

namespace gg::test {

// Two numbers, in the picture's own (linear) units: at most `fraction_over` of the pixels may
// differ by more than `difference` in any channel.
struct PictureTolerance {
  double difference = 0.0;
  double fraction_over = 0.0;
};

struct PictureDifference {
  double largest = 0.0;       // over all pixels and channels; infinite where one is not finite
  int x = 0, y = 0;           // where
  double fraction_over = 0.0; // of pixels that differ by more than the tolerance's difference
};
// Both must have the same size and channels. NaN against NaN is a difference.
PictureDifference difference(const image::Image& picture, const image::Image& reference,
                             double threshold);

// On failure writes NAME.exr, NAME-reference.exr and NAME-difference.exr (absolute), and the same
// three as PNG to look at (clamped, sRGB; the difference scaled so that its largest is white,
// values that are not finite magenta), into the running test's scratch directory, and says where.
::testing::AssertionResult pictures_agree(const image::Image& picture,
                                          const image::Image& reference, PictureTolerance tolerance,
                                          const std::string& name = "picture");

// Success if no value is NaN or infinite; else says where the first is and how many.
::testing::AssertionResult is_finite(const image::Image& picture);

} // namespace gg::test
