// Pictures by formula, the same here and in flip_check.py, so that numbers found there by others'
// software can be committed without the pictures.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>

namespace gg::test {

struct Pair {
  image::Image test, reference;
};

// 0 to 1 in steps of 2^-24.
inline double scattered(std::uint32_t x, std::uint32_t y, std::uint32_t c, std::uint32_t salt) {
  std::uint32_t v = x * 73856093u ^ y * 19349663u ^ c * 83492791u ^ salt * 2654435761u;
  v = (v ^ (v >> 15)) * 2246822519u;
  v = (v ^ (v >> 13)) * 3266489917u;
  return static_cast<double>((v ^ (v >> 16)) >> 8) / 16777216.0;
}

inline Pair formula_pair(const std::string& name) {
  constexpr int width = 96, height = 72;
  Pair pair{image::Image(width, height, 3), image::Image(width, height, 3)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) {
        const double u = x / 95.0, v = y / 71.0;
        const double ramp = c == 0 ? u : c == 1 ? v : 0.25;
        double r = 0.0, t = 0.0;
        if (name == "gradient") { // a little darker and warmer
          r = ramp;
          t = ramp * 0.9 + (c == 0 ? 0.03 : 0.0);
        } else if (name == "checker") { // moved by two pixels
          r = (x / 6 + y / 6) % 2 == 0 ? 0.8 : 0.05;
          t = ((x + 2) / 6 + y / 6) % 2 == 0 ? 0.8 : 0.05;
        } else if (name == "noise") {
          r = 0.1 + 0.6 * ramp;
          t = r
              + 0.2
                    * (scattered(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                 static_cast<std::uint32_t>(c), 1u)
                       - 0.5);
        } else if (name == "colours") { // blocks of full colours, one channel of each turned over
          const int block = x / 12 % 8;
          r = block >> c & 1;
          t = c == y / 24 ? 1.0 - r : r;
        } else if (name == "bright") { // beyond the display, with a line that is missing
          r = x == 40 ? 5.0 : 4.0 * u * v;
          t = 3.5 * u * v;
        }
        pair.reference.at(x, y, c) = static_cast<float>(r);
        pair.test.at(x, y, c) = static_cast<float>(t);
      }
  return pair;
}

} // namespace gg::test
