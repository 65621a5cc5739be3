#include "tables/grid_fit.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace gg::tables {
namespace {

// After these the Gaussians of neighbours are where they will stay.
constexpr int sweeps = 3;
constexpr int scratch_iterations = 24, sweep_iterations = 10;

GaussianSum to_table(const GaussianSum& set, const GridCell& cell) {
  GaussianSum result = set;
  for (Gaussian& g : result) {
    g.angle = (g.angle - cell.centre) / cell.unit;
    g.sigma /= cell.unit;
  }
  return result;
}

GaussianSum from_table(const GaussianSum& set, const GridCell& cell) {
  GaussianSum result = set;
  for (Gaussian& g : result) {
    g.angle = cell.centre + g.angle * cell.unit;
    g.sigma *= cell.unit;
  }
  return result;
}

// The mean of the neighbours that are not empty, in table units.
GaussianSum mean_of_neighbours(const Grid& grid, const std::vector<GaussianSum>& fitted, int x,
                               int y, int z) {
  GaussianSum mean(fitted[grid.index(x, y, z)].size(), {0.0, 0.0, 0.0});
  int count = 0;
  const auto add = [&](int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i >= grid.nx || j >= grid.ny || k >= grid.nz) return;
    if (k / grid.block != z / grid.block || grid.cells[grid.index(i, j, k)].empty) return;
    const GaussianSum& other = fitted[grid.index(i, j, k)];
    for (std::size_t t = 0; t < mean.size(); ++t) {
      mean[t].angle += other[t].angle;
      mean[t].sigma += std::log(other[t].sigma);
      mean[t].weight += other[t].weight;
    }
    ++count;
  };
  for (int d : {-1, 1}) {
    add(x + d, y, z);
    add(x, y + d, z);
    add(x, y, z + d);
  }
  if (count == 0) return {};
  for (Gaussian& g : mean)
    g = {g.angle / count, std::exp(g.sigma / count), g.weight / count};
  return mean;
}

} // namespace

int grid_steps(const Grid& grid) {
  return (1 + sweeps) * grid.ny;
}

std::vector<GaussianSum> fit_grid(const FitViews& views, const Grid& grid, int gaussians,
                                  const Step& step) {
  std::vector<GaussianSum> fitted(grid.cells.size(),
                                  GaussianSum(static_cast<std::size_t>(gaussians)));
  const auto over_all = [&](auto&& work) {
    for (int y = 0; y < grid.ny; ++y) {
      tbb::parallel_for(0, grid.nx * grid.nz, [&](int i) {
        const int x = i % grid.nx, z = i / grid.nx;
        if (!grid.cells[grid.index(x, y, z)].empty) work(x, y, z);
      });
      step();
    }
  };
  over_all([&](int x, int y, int z) {
    const GridCell& cell = grid.cells[grid.index(x, y, z)];
    fitted[grid.index(x, y, z)] = to_table(
        fit_from_scratch(views, cell.target, gaussians, scratch_iterations).gaussians, cell);
  });
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<GaussianSum> next = fitted;
    over_all([&](int x, int y, int z) {
      const GridCell& cell = grid.cells[grid.index(x, y, z)];
      const GaussianSum mean = mean_of_neighbours(grid, fitted, x, y, z);
      if (mean.empty()) return;
      const GaussianSum home = from_table(mean, cell);
      FitResult best = fit(views, cell.target, from_table(fitted[grid.index(x, y, z)], cell),
                           sweep_iterations, home);
      // Three and more Gaussians have minima that are as good and far apart: it takes longer to agree on one.
      if (sweep == 0 || (gaussians > 2 && sweep + 1 < sweeps)) {
        FitResult theirs = fit(views, cell.target, home, sweep_iterations, home);
        if (theirs.cost < best.cost) best = std::move(theirs);
      }
      next[grid.index(x, y, z)] = to_table(best.gaussians, cell);
    });
    fitted = std::move(next);
  }
  // Cells without light take their neighbours' gaussians: of the widest alpha those of the next larger cosine, then downwards.
  for (int z = 0; z < grid.nz; ++z)
    for (int x = grid.nx - 2; x >= 0; --x)
      if (grid.cells[grid.index(x, grid.ny - 1, z)].empty)
        fitted[grid.index(x, grid.ny - 1, z)] = fitted[grid.index(x + 1, grid.ny - 1, z)];
  for (int y = grid.ny - 2; y >= 0; --y)
    for (int z = 0; z < grid.nz; ++z)
      for (int x = 0; x < grid.nx; ++x)
        if (grid.cells[grid.index(x, y, z)].empty)
          fitted[grid.index(x, y, z)] = fitted[grid.index(x, y + 1, z)];
  return fitted;
}

std::vector<float> offsets_and_widths(const Grid& grid, const std::vector<GaussianSum>& sets,
                                      int gaussians) {
  std::vector<float> texels(4 * static_cast<std::size_t>(gaussians) * grid.cells.size());
  std::size_t texel = 0;
  for (int z = 0; z < grid.nz; ++z)
    for (int k = 0; k < gaussians; ++k)
      for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x, texel += 4) {
          const Gaussian& g = sets[grid.index(x, y, z)][static_cast<std::size_t>(k)];
          // The lean of a lobe fades faster than its width: at alpha 0 it is gone.
          texels[texel] = y == 0 ? 0.0f : static_cast<float>(g.angle);
          texels[texel + 1] = static_cast<float>(g.sigma);
          texels[texel + 2] = static_cast<float>(g.weight);
        }
  return texels;
}

} // namespace gg::tables
