#include "tables/make_reflection.h"

#include "glsl/f64.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;
constexpr int energy_size = glsl::ENERGY_TABLE_SIZE, lobe_size = glsl::LOBE_TABLE_SIZE,
              lobe_slices = glsl::LOBE_TABLE_SLICES;

constexpr int energy_points = 96; // squared: energies are good to 1e-4 (tests/tables)
constexpr int lobe_points =
    1024; // the fits' own noise, from the choice of maps, is ten times that of these

// The lobe seen exactly along the surface has no density to sample by; this close to it, it has its limit's shape.
constexpr double least_cos = 1e-3;

// GGX's tail is as wide as the sphere whatever alpha; beyond these a Gaussian's place says nothing that is seen.
constexpr double greatest_width = 60.0, least_lean = -1.0, greatest_lean = 2.0;

// The lean that leads from the mirror direction at angle `theta` to `angle` (both from the normal): see lobeDirection.
double lean_of(double angle, double theta) {
  const double back = std::sin(theta - angle), along = std::sin(angle) + back;
  return along > 0.0 ? std::clamp(back / along, least_lean, greatest_lean) : greatest_lean;
}

} // namespace

EnergyCell make_reflection_energy_cell(const Model& model, int x, int y) {
  const CellAxes at = energy_axes(x, y);
  return fit_energy(model, at.alpha, at.cos_theta, energy_points);
}

int reflection_energy_steps() {
  return energy_size;
}

ReflectionEnergyTable make_reflection_energy(const Model& model, const Step& step) {
  ReflectionEnergyTable table{model, std::vector<float>(4 * energy_size * energy_size)};
  for (int y = 0; y < energy_size; ++y) {
    tbb::parallel_for(0, energy_size, [&](int x) {
      const EnergyCell cell = make_reflection_energy_cell(model, x, y);
      float* texel = &table.texels[4 * static_cast<std::size_t>(y * energy_size + x)];
      texel[0] = static_cast<float>(cell.albedo);
      texel[1] = static_cast<float>(cell.cos1);
      texel[2] = static_cast<float>(cell.cos2);
      texel[3] = static_cast<float>(cell.share1);
    });
    step();
  }
  return table;
}

GridCell reflection_cell(const FitViews& views, const Model& model, int x, int y, int slice) {
  const CellAxes at = lobe_axes(x, y, slice);
  GridCell cell;
  if (!(at.alpha > 0.0)) return cell;
  const double cos_theta = std::max(at.cos_theta, least_cos);
  const std::vector<LobeSample> lobe =
      reflection_lobe(model, at.alpha, cos_theta, Walk::lattice, lobe_points);
  double flat_sum = 0.0, edge_sum = 0.0;
  for (const LobeSample& s : lobe) {
    flat_sum += s.weight;
    edge_sum += s.weight * glsl::schlickWeight(s.cos_facet);
  }
  std::vector<double> weights;
  for (const LobeSample& s : lobe)
    weights.push_back(
        s.weight
        * ((1.0 - at.edge) / flat_sum + at.edge * glsl::schlickWeight(s.cos_facet) / edge_sum));
  cell.empty = false;
  cell.centre = std::acos(cos_theta);
  cell.unit = at.alpha;
  cell.target = fit_target(views, lobe, weights, cos_theta == 1.0);
  return cell;
}

int reflection_grid_steps() {
  return lobe_size;
}

int reflection_lobe_steps() {
  return grid_steps({0, lobe_size, 0, 1, {}});
}

Grid reflection_grid(const FitViews& views, const Model& model, const Step& step) {
  // The far tail's share is no neighbour's affair.
  Grid grid{lobe_size, lobe_size, lobe_slices, 1, {}};
  grid.cells.resize(static_cast<std::size_t>(grid.nx * grid.ny * grid.nz));
  for (int y = 0; y < grid.ny; ++y) {
    tbb::parallel_for(0, grid.nx * grid.nz, [&](int i) {
      const int x = i % grid.nx, slice = i / grid.nx;
      grid.cells[grid.index(x, y, slice)] = reflection_cell(views, model, x, y, slice);
    });
    step();
  }
  return grid;
}

ReflectionLobeTable make_reflection_lobes(const Model& model, const FitViews& views,
                                          const Grid& grid, int gaussians, const Step& step) {
  const std::vector<GaussianSum> sets = fit_grid(views, grid, gaussians, step);
  ReflectionLobeTable table{model, gaussians, {}};
  table.texels.resize(4 * static_cast<std::size_t>(gaussians) * grid.cells.size());
  for (int slice = 0; slice < grid.nz; ++slice)
    for (int k = 0; k < gaussians; ++k)
      for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
          const auto gaussian = static_cast<std::size_t>(k);
          const Gaussian& g = sets[grid.index(x, y, slice)][gaussian];
          float* texel = &table.texels[4
                                       * static_cast<std::size_t>(
                                           ((slice * gaussians + k) * grid.ny + y) * grid.nx + x)];
          // Straight down the mirror direction is the normal, and how far to lean between them means nothing: the
          // neighbour's.
          const std::size_t leans = grid.index(std::min(x, grid.nx - 2), y, slice);
          const GridCell& cell = grid.cells[leans];
          const double angle = cell.centre + sets[leans][gaussian].angle * cell.unit;
          texel[0] = y == 0 ? 0.0f : static_cast<float>(lean_of(angle, cell.centre));
          texel[1] = static_cast<float>(std::min(g.sigma, greatest_width));
          texel[2] = static_cast<float>(g.weight);
        }
  return table;
}

} // namespace gg::tables
