// Makes the tables of the reflection lobe: every cell integrated and fitted.
#include "core/progress.h"
#include "glsl/f64.h"
#include "tables/energy.h"
#include "tables/gaussian_fit.h"
#include "tables/reflection_table.h"
#include "tables/training_maps.h"

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
constexpr int map_size = 256, rotations_per_map = 96;
constexpr unsigned seed = 1;

// The lobe seen exactly along the surface has no density to sample by; this close to it, it has its limit's shape.
constexpr double least_cos = 1e-3;

} // namespace

std::vector<float> make_energy_cell(const Model& model, int x, int y) {
  const CellAxes at = energy_axes(x, y);
  const EnergyCell cell = fit_energy(model, at.alpha, at.cos_theta, energy_points);
  return {static_cast<float>(cell.albedo), static_cast<float>(cell.cos1),
          static_cast<float>(cell.cos2), static_cast<float>(cell.share1)};
}

std::vector<float> make_lobe_column(const Model& model, const Training& training, int x, int y) {
  // Straight down the mirror direction is the normal, and how far to lean between them means nothing: the neighbour's.
  const double cos_theta =
      std::clamp(lobe_axes(x, y, 0).cos_theta, least_cos, lobe_axes(lobe_size - 2, y, 0).cos_theta);
  const double alpha = lobe_axes(x, y, 0).alpha;
  const double fitted = std::max(alpha, lobe_axes(x, first_fitted_row, 0).alpha);
  const LobeRadiance truth = lobe_radiance(
      training, reflection_lobe(model, fitted, cos_theta, Walk::lattice, lobe_points));
  std::vector<float> column;
  for (int slice = 0; slice < lobe_slices; ++slice) {
    const Tap tap = fit(training, truth, lobe_axes(x, y, slice).edge, fitted, cos_theta);
    const double scale = alpha / fitted;
    column.push_back(static_cast<float>(tap.lean * scale * scale));
    // Narrow lobes near the normal have so little of their energy from the edge that its share, far out in the tail, is
    // never asked for; it is kept to widths that can be interpolated with.
    column.push_back(static_cast<float>(std::min(tap.sigma / fitted, 3.5)));
  }
  return column;
}

Training make_training(Progress* progress) {
  std::vector<SphereStack> stacks;
  for (int draw : fitted_draws) {
    if (progress) progress->update(0, "painting environments");
    for (const TrainingMap& map : training_maps(map_size, draw)) {
      if (progress) progress->update(0, "blurring " + map.name);
      stacks.emplace_back(map.map);
    }
  }
  return Training(std::move(stacks), rotations_per_map, seed);
}

long rows_of_work() {
  return energy_size + lobe_size;
}

ReflectionTable make(const Model& model, const Training& training, Progress* progress,
                     long done_before) {
  ReflectionTable table;
  table.model = model;
  table.energy.resize(4 * energy_size * energy_size);
  table.lobe.resize(4 * static_cast<std::size_t>(lobe_size * lobe_size * lobe_slices));
  for (int y = 0; y < energy_size; ++y) {
    tbb::parallel_for(0, energy_size, [&](int x) {
      const std::vector<float> cell = make_energy_cell(model, x, y);
      std::ranges::copy(cell, table.energy.begin() + 4 * (y * energy_size + x));
    });
    if (progress) progress->update(done_before + y + 1, name(model) + " energy");
  }
  for (int y = 0; y < lobe_size; ++y) {
    tbb::parallel_for(0, lobe_size, [&](int x) {
      const std::vector<float> column = make_lobe_column(model, training, x, y);
      for (int slice = 0; slice < lobe_slices; ++slice)
        std::copy_n(column.begin() + 2 * slice, 2,
                    table.lobe.begin() + 4 * ((slice * lobe_size + y) * lobe_size + x));
    });
    if (progress) progress->update(done_before + energy_size + y + 1, name(model) + " lobe");
  }
  return table;
}

} // namespace gg::tables
