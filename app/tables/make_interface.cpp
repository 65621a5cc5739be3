#include "tables/make_interface.h"

#include "glsl/f64.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;

constexpr int energy_points = 48; // squared
constexpr int lobe_points =
    768; // the fits' own noise, from the choice of maps, is ten times that of these
constexpr std::size_t least_points = 96; // a lobe of fewer has no shape

constexpr int slices = 2 * glsl::INTERFACE_SLICES;

} // namespace

InterfaceShares make_interface_energy_cell(const Model& model, int x, int y, int slice) {
  const InterfaceAxes at = interface_energy_axes(x, y, slice);
  if (at.alpha > 0.0) return interface_shares(model, at.alpha, at.cos_theta, at.eta, energy_points);
  const double through = glsl::fresnelTransmittedAt(at.cos_theta, at.eta);
  return {through, 1.0 - through};
}

int interface_energy_steps() {
  return glsl::INTERFACE_ENERGY_ALPHAS;
}

InterfaceEnergyTable make_interface_energy(const Model& model, const Step& step) {
  constexpr int nx = glsl::INTERFACE_ENERGY_COSINES, ny = glsl::INTERFACE_ENERGY_ALPHAS;
  InterfaceEnergyTable table{model, std::vector<float>(std::size_t{4} * nx * ny * slices)};
  for (int y = 0; y < ny; ++y) {
    tbb::parallel_for(0, nx * slices, [&](int i) {
      const int x = i % nx, slice = i / nx;
      const InterfaceShares shares = make_interface_energy_cell(model, x, y, slice);
      const auto texel = 4 * static_cast<std::size_t>((slice * ny + y) * nx + x);
      table.texels[texel] = static_cast<float>(shares.transmitted);
      table.texels[texel + 1] = static_cast<float>(shares.reflected);
    });
    step();
  }
  return table;
}

GridCell interface_cell(const FitViews& views, const Model& model, int x, int y, int slice) {
  const InterfaceAxes at = interface_lobe_axes(x, y, slice);
  GridCell cell;
  if (!(at.alpha > 0.0)) return cell;
  cell.centre = glsl::interfaceSnell(at.cos_theta, at.eta);
  cell.unit = glsl::interfaceWidth(at.cos_theta, at.alpha, at.eta);
  const std::vector<LobeSample> lobe =
      transmission_lobe(model, at.alpha, at.cos_theta, at.eta, lobe_points);
  if (lobe.size() < least_points) return cell;
  std::vector<double> weights;
  for (const LobeSample& s : lobe)
    weights.push_back(s.weight);
  cell.empty = false;
  cell.target = fit_target(views, lobe, weights, at.cos_theta == 1.0);
  return cell;
}

int interface_grid_steps() {
  return glsl::INTERFACE_LOBE_ALPHAS;
}

int interface_lobe_steps() {
  return grid_steps({0, glsl::INTERFACE_LOBE_ALPHAS, 0, 1, {}});
}

Grid interface_grid(const FitViews& views, const Model& model, const Step& step) {
  Grid grid{glsl::INTERFACE_LOBE_COSINES,
            glsl::INTERFACE_LOBE_ALPHAS,
            slices,
            glsl::INTERFACE_SLICES,
            {}};
  grid.cells.resize(static_cast<std::size_t>(grid.nx * grid.ny * grid.nz));
  for (int y = 0; y < grid.ny; ++y) {
    tbb::parallel_for(0, grid.nx * grid.nz, [&](int i) {
      const int x = i % grid.nx, slice = i / grid.nx;
      grid.cells[grid.index(x, y, slice)] = interface_cell(views, model, x, y, slice);
    });
    step();
  }
  return grid;
}

InterfaceLobeTable make_interface_lobes(const Model& model, const FitViews& views, const Grid& grid,
                                        int gaussians, const Step& step) {
  return {model, gaussians,
          offsets_and_widths(grid, fit_grid(views, grid, gaussians, step), gaussians)};
}

} // namespace gg::tables
