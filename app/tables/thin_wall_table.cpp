#include "tables/thin_wall_table.h"

#include "glsl/f64.h"
#include "tables/table_file.h"

#include <algorithm>
#include <cmath>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;

constexpr double least_cos = 1e-3, least_share = 5e-4; // as in interface_table.cpp

TableLayout layout(int lobes) {
  const std::string axes = "x sqrt(cos theta), y sqrt(alpha), nodes at i / (size - 1); below each "
                           "other (n - 1) / (n + 1) for n from 1 to 4";
  const int height = glsl::THIN_WALL_ALPHAS * glsl::THIN_WALL_SLICES;
  if (lobes == 0)
    return {"thin-wall-energy-",
            glsl::THIN_WALL_COSINES,
            height,
            {"transmitted", "reflected first", "reflected later"},
            axes,
            0.0f,
            1.5f}; // Phong gains energy
  return {"thin-wall-lobes" + std::to_string(lobes) + "-",
          glsl::THIN_WALL_COSINES,
          height * lobes,
          {"offset", "width", "weight"},
          axes + "; every slice holds the lobes below each other, narrowest first",
          -64.0f,
          64.0f};
}

} // namespace

WallAxes thin_wall_axes(int x, int y, int slice) {
  const double greatest =
      (glsl::INTERFACE_GREATEST_ETA - 1.0) / (glsl::INTERFACE_GREATEST_ETA + 1.0);
  const double share = std::max(greatest * slice / (glsl::THIN_WALL_SLICES - 1.0), least_share);
  return {std::clamp(std::pow(x / (glsl::THIN_WALL_COSINES - 1.0), 2.0), least_cos, 1.0),
          std::pow(y / (glsl::THIN_WALL_ALPHAS - 1.0), 2.0), (1.0 + share) / (1.0 - share)};
}

void write(const std::filesystem::path& directory, const ThinWallTable& table) {
  write_table(directory, layout(table.lobes), table.model, table.texels);
}

ThinWallTable read_thin_wall(const std::filesystem::path& directory, const Model& model,
                             int lobes) {
  return {model, lobes, read_table(directory, layout(lobes), model)};
}

} // namespace gg::tables
