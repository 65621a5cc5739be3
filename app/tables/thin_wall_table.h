// The tables of a thin wall, as shaders read them: axes, memory, files.
#pragma once

#include "tables/lobe.h"

#include <filesystem>
#include <vector>

namespace gg::tables {

// Sizes and axes are those of shaders/refraction/thin_wall_table.glsl; texels as in interface_table.h.
struct ThinWallTable {
  Model model;
  int lobes =
      0; // 0: energies (transmitted, reflected first and later), else lobes (offset, width, weight)
  std::vector<float> texels; // RGBA
};
inline constexpr int most_wall_lobes = 2;

struct WallAxes {
  double cos_theta, alpha, eta;
};
// Of a node; never exactly along the surface nor at index 1 (as interface_lobe_axes).
WallAxes thin_wall_axes(int x, int y, int slice);

// thin-wall-energy-NAME.exr and thin-wall-lobesK-NAME.exr, slices below each other. Reading throws Error(input) if a file is
// missing or is not such a table.
void write(const std::filesystem::path& directory, const ThinWallTable& table);
ThinWallTable read_thin_wall(const std::filesystem::path& directory, const Model& model, int lobes);

} // namespace gg::tables
