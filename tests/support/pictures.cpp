#include "support/pictures.h"

#include "support/scratch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gg::test {
namespace {

using image::Image;

std::string size_of(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " x "
         + std::to_string(image.channels);
}

double distance(float a, float b) {
  const double d = std::abs(static_cast<double>(a) - static_cast<double>(b));
  return std::isfinite(d) ? d : std::numeric_limits<double>::infinity();
}

// For the eye: display-encoded RGB, magenta where a value is not finite.
Image shown(const Image& linear, double scale) {
  Image out(linear.width, linear.height, 3);
  const int last = std::min(linear.channels, 3) - 1;
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; ++x) {
      bool finite = true;
      for (int c = 0; c < 3; ++c) {
        const float v = linear.at(x, y, std::min(c, last));
        finite &= std::isfinite(v);
        if (finite)
          out.at(x, y, c) =
              static_cast<float>(image::srgb_from_linear(static_cast<double>(v) * scale));
      }
      if (!finite)
        for (int c = 0; c < 3; ++c)
          out.at(x, y, c) = c == 1 ? 0.0f : 1.0f;
    }
  return out;
}

void write_both(const std::string& name, const Image& image, double scale) {
  image::write(scratch_directory() / (name + ".exr"), image);
  image::write(scratch_directory() / (name + ".png"), shown(image, scale));
}

} // namespace

PictureDifference difference(const Image& picture, const Image& reference, double threshold) {
  PictureDifference result;
  long over = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      double worst = 0.0;
      for (int c = 0; c < picture.channels; ++c)
        worst = std::max(worst, distance(picture.at(x, y, c), reference.at(x, y, c)));
      over += worst > threshold;
      if (worst > result.largest) {
        result.largest = worst;
        result.x = x;
        result.y = y;
      }
    }
  const double pixels = static_cast<double>(picture.width) * picture.height;
  result.fraction_over = pixels > 0.0 ? static_cast<double>(over) / pixels : 0.0;
  return result;
}

::testing::AssertionResult pictures_agree(const Image& picture, const Image& reference,
                                          PictureTolerance tolerance, const std::string& name) {
  if (picture.width != reference.width || picture.height != reference.height
      || picture.channels != reference.channels)
    return ::testing::AssertionFailure()
           << name << " is " << size_of(picture) << ", the reference " << size_of(reference);
  const PictureDifference found = difference(picture, reference, tolerance.difference);
  if (found.fraction_over <= tolerance.fraction_over) return ::testing::AssertionSuccess();

  Image apart(picture.width, picture.height, picture.channels);
  for (std::size_t i = 0; i < apart.values.size(); ++i)
    apart.values[i] = std::abs(picture.values[i] - reference.values[i]);
  write_both(name, picture, 1.0);
  write_both(name + "-reference", reference, 1.0);
  const bool scalable = std::isfinite(found.largest) && found.largest > 0.0;
  write_both(name + "-difference", apart, scalable ? 1.0 / found.largest : 1.0);
  return ::testing::AssertionFailure()
         << name << ": " << 100.0 * found.fraction_over << " % of the pixels differ by more than "
         << tolerance.difference << " (allowed " << 100.0 * tolerance.fraction_over
         << " %), the largest by " << found.largest << " at (" << found.x << ", " << found.y
         << "). Pictures in " << scratch_directory().string();
}

::testing::AssertionResult is_finite(const Image& picture) {
  const auto bad = image::find_non_finite(picture);
  if (!bad) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << bad->pixels << " pixels are not finite, the first (" << bad->x << ", " << bad->y
         << ") with " << bad->value << " in channel " << bad->channel;
}

} // namespace gg::test
