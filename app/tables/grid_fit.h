// Tap sets over a whole table: every cell fitted, and all of them made to agree with their neighbours, so that what is
// interpolated between two cells is again a good fit.
#pragma once

#include "tables/tap_fit.h"

#include <functional>

namespace gg::tables {

struct GridCell {
  bool empty = true; // no light: filled from the cell with the next larger y
  FitTarget target;  // of cells that are not empty
  double centre =
      0.0; // tables hold (angle - centre) / unit and sigma / unit, which vary little from cell to cell
  double unit = 1.0;
};

struct Grid {
  int nx = 0, ny = 0, nz = 0;
  std::vector<GridCell> cells; // x fastest
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * ny + y) * nx + x);
  }
};

// In table units, x fastest: for every cell as many Gaussians as taps. `step` is called after each of grid_steps() shares
// of the work, never by two threads at once.
std::vector<TapSet> fit_grid(const FitViews& views, const Grid& grid, int taps,
                             const std::function<void()>& step);
int grid_steps(const Grid& grid);

} // namespace gg::tables
