#include "tables/interface_table.h"

#include "glsl/f64.h"
#include "tables/table_file.h"

#include <algorithm>
#include <cmath>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;

constexpr double least_cos =
    1e-3; // a facet's width from the horizon for all but the narrowest lobes
constexpr double least_share = 5e-4; // of (n - 1) / (n + 1): index 1.001

InterfaceAxes axes(int x, int y, int slice, int cosines, int alphas) {
  const int n = glsl::INTERFACE_SLICES;
  const double greatest =
      (glsl::INTERFACE_GREATEST_ETA - 1.0) / (glsl::INTERFACE_GREATEST_ETA + 1.0);
  const double share = std::max(greatest * (slice % n) / (n - 1.0), least_share);
  const double index = (1.0 + share) / (1.0 - share);
  const double eta = slice < n ? index : 1.0 / index;
  return {std::clamp(glsl::interfaceCosineAt(x / (cosines - 1.0), eta), least_cos, 1.0),
          std::pow(y / (alphas - 1.0), 2.0), eta};
}

constexpr const char* axes_text =
    "x cos theta (entering sqrt, leaving split at the critical angle), y sqrt(alpha), nodes at "
    "i / (size - 1); below each other (n - 1) / (n + 1) for n from 1 to 4, entering, then leaving";

TableLayout energy_layout() {
  return {"interface-energy-",
          glsl::INTERFACE_ENERGY_COSINES,
          glsl::INTERFACE_ENERGY_ALPHAS * 2 * glsl::INTERFACE_SLICES,
          {"transmitted", "reflected"},
          axes_text,
          0.0f,
          1.5f}; // Phong gains energy
}

TableLayout lobe_layout(int lobes) {
  return {
      "interface-lobes" + std::to_string(lobes) + "-",
      glsl::INTERFACE_LOBE_COSINES,
      glsl::INTERFACE_LOBE_ALPHAS * lobes * 2 * glsl::INTERFACE_SLICES,
      {"offset", "width", "weight"},
      std::string(axes_text) + "; every slice holds the lobes below each other, narrowest first",
      // Nearly smooth glass past the critical angle: what little gets through is many widths from Snell's direction.
      -512.0f,
      512.0f};
}

} // namespace

InterfaceAxes interface_energy_axes(int x, int y, int slice) {
  return axes(x, y, slice, glsl::INTERFACE_ENERGY_COSINES, glsl::INTERFACE_ENERGY_ALPHAS);
}

InterfaceAxes interface_lobe_axes(int x, int y, int slice) {
  return axes(x, y, slice, glsl::INTERFACE_LOBE_COSINES, glsl::INTERFACE_LOBE_ALPHAS);
}

void write(const std::filesystem::path& directory, const InterfaceEnergyTable& table) {
  write_table(directory, energy_layout(), table.model, table.texels);
}

void write(const std::filesystem::path& directory, const InterfaceLobeTable& table) {
  write_table(directory, lobe_layout(table.lobes), table.model, table.texels);
}

InterfaceEnergyTable read_interface_energy(const std::filesystem::path& directory,
                                           const Model& model) {
  return {model, read_table(directory, energy_layout(), model)};
}

InterfaceLobeTable read_interface_lobes(const std::filesystem::path& directory, const Model& model,
                                        int lobes) {
  return {model, lobes, read_table(directory, lobe_layout(lobes), model)};
}

} // namespace gg::tables
