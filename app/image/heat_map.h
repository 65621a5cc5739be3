// A picture of numbers, with the scale that says which colour is which.
#pragma once

#include "image/image.h"

#include <array>
#include <string>

namespace gg::image {

// A perceptual colour map: `t` in 0..1 (clamped) to sRGB-encoded values. Lightness L* rises evenly
// from 4 to 96 while the hue goes from violet by red to yellow, so it also reads in grey.
std::array<float, 3> heat_colour(double t);

// The one-channel `values` from 0 (darkest) to `top` (brightest; values above are shown as it), and
// under them a bar with numbers and `title`. Display-encoded RGB; at least 320 wide, so that the
// legend can be read, and 72 higher than `values`.
Image heat_map(const Image& values, double top, const std::string& title);

// The smallest of 1, 2, 5, 10, ... times a power of ten that is no smaller than 99 % of the values.
double round_top(const Image& values);

} // namespace gg::image
