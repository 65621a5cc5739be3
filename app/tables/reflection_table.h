// The tables of the reflection lobe, as shaders read them: made, stored in assets/tables, read back.
#pragma once

#include "tables/lobe.h"

#include <filesystem>
#include <vector>

namespace gg {
class Progress;
}

namespace gg::tables {

class Training;

// Sizes are those of shaders/environment/lobe_table.glsl. First axis sqrt(cos theta), second sqrt(alpha), nodes at
// i / (size - 1), first node first.
struct ReflectionTable {
  Model model;
  // RGBA: albedo for F = 1, cos1, cos2, share1 (energy.h).
  std::vector<float> energy;
  // RGBA, third axis the share of the energy from Schlick's edge: lean, sigma / alpha, 0, 0.
  std::vector<float> lobe;
};

struct CellAxes {
  double cos_theta, alpha, edge;
};
CellAxes energy_axes(int x, int y);
CellAxes lobe_axes(int x, int y, int slice);

// Narrower lobes than this are not fitted: their taps are those of this width, scaled (sigma / alpha kept, lean as
// alpha²). At its sigma, 0.02, the training maps end.
inline constexpr int first_fitted_row = 4; // alpha 0.0166

// One cell of either table, as generated: what the tests fit again.
std::vector<float> make_energy_cell(const Model& model, int x, int y);
std::vector<float> make_lobe_column(const Model& model, const Training& training, int x,
                                    int y); // of all slices

// The maps that the Gaussians are fitted on. Takes a minute.
Training make_training(Progress* progress);

// Every cell, in parallel. `progress` counts rows: rows_of_work() for every model.
ReflectionTable make(const Model& model, const Training& training, Progress* progress,
                     long done_before);
long rows_of_work();

// reflection-energy-NAME.exr and reflection-lobe-NAME.exr (slices below each other), half floats, channels by name.
void write(const std::filesystem::path& directory, const ReflectionTable& table);
// Throws Error(input) if a file is missing, or is not a table of the size that the shaders expect.
ReflectionTable read(const std::filesystem::path& directory, const Model& model);

} // namespace gg::tables
