// Pearson's test of samples against a density on the sphere.
#pragma once

#include "bsdf/distributions.h"

#include <cstdint>

namespace gg::bsdf_test {

struct ChiSquare {
  double statistic = 0;
  int degrees = 0;   // of freedom
  double p = 0;      // chance of a statistic at least this large if the sampler is right
  double inside = 0; // the density's integral over the sphere
};

// Draws 100,000 directions and counts them on a grid of rings and sectors; `density` (1/sr) is
// integrated over each cell on a grid of its own. A sampler may return vec3(0) or a direction that
// it rejects by density 0: what the density lacks to 1 is expected there. Cells with fewer than 5
// expected samples are pooled.
struct Cells {
  double alpha = 1; // width of what is sampled
  double side = 1;  // +1: upper half, -1: lower half
  int fine = 12;    // density points per cell and axis; more where the density has edges
};
ChiSquare chi_square(const Cells& cells, const std::function<vec3(vec2)>& sample,
                     const std::function<double(vec3)>& density, std::uint64_t seed);

} // namespace gg::bsdf_test
