// Sums of Gaussians over a whole table: every cell fitted, and all of them made to agree with their neighbours, so that what is
// interpolated between two cells is again a good fit.
#pragma once

#include "tables/gaussian_fit.h"

#include <functional>

namespace gg::tables {

// Called by one thread at a time, after each of a number of shares of the work.
using Step = std::function<void()>;

struct GridCell {
  bool empty = true; // no light: filled from the cell with the next larger y
  FitTarget target;  // of cells that are not empty
  double centre =
      0.0; // tables hold (angle - centre) / unit and sigma / unit, which vary little from cell to cell
  double unit = 1.0;
};

struct Grid {
  int nx = 0, ny = 0, nz = 0;
  int block =
      1; // slices that follow each other smoothly: neighbours along z are sought within blocks of as many
  std::vector<GridCell> cells; // x fastest
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * ny + y) * nx + x);
  }
};

// In table units, x fastest: for every cell as many Gaussians as gaussians. grid_steps() steps.
std::vector<GaussianSum> fit_grid(const FitViews& views, const Grid& grid, int gaussians,
                                  const Step& step);
int grid_steps(const Grid& grid);

// As texels of a table: offset, width, weight, 0; x fastest, then y, one block of rows after the other for every gaussian.
std::vector<float> offsets_and_widths(const Grid& grid, const std::vector<GaussianSum>& sets,
                                      int gaussians);

} // namespace gg::tables
