// The balance of what the sharp level's texels read near the corners of the cube.
#pragma once

#include <cstddef>
#include <vector>

namespace gg::environment {

struct PixelFactor {
  std::size_t pixel; // row * width + column
  float factor;      // of the pixel's weight
};

// Near a corner the three lattices that meet there add up a small blob of light 0.3 % wrong: factors near 1 for the pixels
// around the eight corners that make up for it, found by Sinkhorn and Knopp's balancing of the readings with
// rows of the given weights (balanced_rows). `sigma`, `reach` as of environment_equirect.comp, `face` texels along an edge.
std::vector<PixelFactor> balanced_corners(int width, int height, int face, double sigma,
                                          double reach, const std::vector<float>& row_weights);

} // namespace gg::environment
