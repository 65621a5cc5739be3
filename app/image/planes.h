// Single-channel pictures and separable filters over them.
#pragma once

#include <cstddef>
#include <vector>

namespace gg::image {

struct Plane {
  int width = 0, height = 0;
  std::vector<float> values; // row by row from the top

  Plane() = default;
  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  float& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                  + static_cast<std::size_t>(x)];
  }
};

// An odd number of weights around the middle one.
using Kernel = std::vector<float>;

// Correlation with across(x) * down(y); beyond the edges the outermost pixels are repeated.
Plane convolve(const Plane& plane, const Kernel& across, const Kernel& down);

} // namespace gg::image
