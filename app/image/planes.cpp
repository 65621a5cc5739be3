#include "image/planes.h"

#include <algorithm>

namespace gg::image {

// Both passes add one weight's contribution to a whole row at a time: simple for the compiler to
// vectorise.
Plane convolve(const Plane& plane, const Kernel& across, const Kernel& down) {
  const std::size_t width = static_cast<std::size_t>(plane.width);
  const std::size_t height = static_cast<std::size_t>(plane.height);
  const std::size_t reach_x = across.size() / 2, reach_y = down.size() / 2;
  Plane rows(plane.width, plane.height), result(plane.width, plane.height);
  std::vector<float> padded(width + 2 * reach_x);
  for (std::size_t y = 0; y < height; ++y) {
    const float* const from = &plane.values[y * width];
    std::fill_n(padded.begin(), reach_x, from[0]);
    std::copy_n(from, width, padded.begin() + static_cast<std::ptrdiff_t>(reach_x));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(reach_x), reach_x, from[width - 1]);
    float* const to = &rows.values[y * width];
    for (std::size_t k = 0; k < across.size(); ++k)
      for (std::size_t x = 0; x < width; ++x)
        to[x] += across[k] * padded[x + k];
  }
  for (std::size_t y = 0; y < height; ++y) {
    float* const to = &result.values[y * width];
    for (std::size_t k = 0; k < down.size(); ++k) {
      const std::size_t row = std::min(std::max(y + k, reach_y) - reach_y, height - 1);
      const float* const from = &rows.values[row * width];
      for (std::size_t x = 0; x < width; ++x)
        to[x] += down[k] * from[x];
    }
  }
  return result;
}

} // namespace gg::image
