// The tables of the reflection lobe, as shaders read them: axes, memory, files.
#pragma once

#include "tables/lobe.h"

#include <filesystem>
#include <vector>

namespace gg::tables {

// Sizes are those of shaders/environment/lobe_table.glsl. RGBA texels, first axis sqrt(cos theta), second sqrt(alpha), nodes
// at i / (size - 1), first node first.
struct ReflectionEnergyTable {
  Model model;
  std::vector<float> texels; // albedo for F = 1, cos1, cos2, share1 (energy.h)
};
// One block of rows after the other for every lobe; third axis the share of the energy from Schlick's edge.
struct ReflectionLobeTable {
  Model model;
  int lobes = 1;
  std::vector<float> texels; // lean, sigma / alpha, weight, 0
};

struct CellAxes {
  double cos_theta, alpha, edge;
};
CellAxes energy_axes(int x, int y);
CellAxes lobe_axes(int x, int y, int slice);

// reflection-energy-NAME.exr and reflection-lobesK-NAME.exr (slices below each other). Reading throws Error(input) if a file
// is missing, or is not such a table.
void write(const std::filesystem::path& directory, const ReflectionEnergyTable& table);
void write(const std::filesystem::path& directory, const ReflectionLobeTable& table);
ReflectionEnergyTable read_reflection_energy(const std::filesystem::path& directory,
                                             const Model& model);
ReflectionLobeTable read_reflection_lobes(const std::filesystem::path& directory,
                                          const Model& model, int lobes);

} // namespace gg::tables
