// The tables of one rough interface, as shaders read them: axes, memory, files.
#pragma once

#include "tables/lobe.h"

#include <filesystem>
#include <vector>

namespace gg::tables {

// Sizes and axes are those of shaders/refraction/interface_table.glsl. RGBA texels, x (cosine) fastest, then y (alpha,
// one block after the other for every lobe), then the slices of eta, entering before leaving.
struct InterfaceEnergyTable {
  Model model;
  std::vector<float> texels; // transmitted, reflected, 0, 0
};
struct InterfaceLobeTable {
  Model model;
  int lobes = 1;
  std::vector<float> texels; // (angle - Snell's) / width, sigma / width, weight, 0
};

struct InterfaceAxes {
  double cos_theta, alpha, eta;
};
// Of a node; `slice` counts entering and leaving. Never exactly along the surface, where no facet is seen, nor at an index
// of exactly 1, where nothing is bent: so close to both that the limit's shape is reached.
InterfaceAxes interface_energy_axes(int x, int y, int slice);
InterfaceAxes interface_lobe_axes(int x, int y, int slice);

// interface-energy-NAME.exr and interface-lobesK-NAME.exr: slices below each other. Reading throws Error(input) if a file is
// missing or is not such a table.
void write(const std::filesystem::path& directory, const InterfaceEnergyTable& table);
void write(const std::filesystem::path& directory, const InterfaceLobeTable& table);
InterfaceEnergyTable read_interface_energy(const std::filesystem::path& directory,
                                           const Model& model);
InterfaceLobeTable read_interface_lobes(const std::filesystem::path& directory, const Model& model,
                                        int lobes);

} // namespace gg::tables
