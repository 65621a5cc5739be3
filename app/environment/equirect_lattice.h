// What the device reads of an equirectangular map to make the sharp level of the cube.
#pragma once

#include "environment/map.h"

#include <vector>

namespace gg::environment {

// Pixels of a sphere crowd at the poles, and three lattices meet at the cube's corners: so that each pixel gives the light that
// it has, it counts for its solid angle times two balances near 1 (zonal.h, corner_balance.h).
struct EquirectLattice {
  // One per pixel: radiance over `unit`, and what the pixel counts for beside its row.
  std::vector<float> texels;
  // Of the map's width. Row 0, of the map's rows: sine and cosine of theta, what a pixel counts for. Row 1, of its columns: cosine
  // and sine of phi. Row 2: those of the step from one column to the next.
  std::vector<float> rows;
};

// For a cube of faces `face` texels wide, read by a Gaussian of `sigma` radians that ends at `reach` sigma.
EquirectLattice equirect_lattice(const Map& map, int face, float unit, double sigma, double reach);

} // namespace gg::environment
