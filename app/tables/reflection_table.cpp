#include "tables/reflection_table.h"

#include "glsl/f64.h"
#include "tables/table_file.h"

#include <cmath>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;
constexpr int energy_size = glsl::ENERGY_TABLE_SIZE, lobe_size = glsl::LOBE_TABLE_SIZE,
              lobe_slices = glsl::LOBE_TABLE_SLICES;

TableLayout energy_layout() {
  return {"reflection-energy-",
          energy_size,
          energy_size,
          {"albedo", "cos1", "cos2", "share1"},
          "x sqrt(cos theta), y sqrt(alpha), nodes at i / (size - 1)",
          0.0f,
          1.5f}; // Phong gains energy
}

TableLayout lobe_layout(int lobes) {
  return {
      "reflection-lobes" + std::to_string(lobes) + "-",
      lobe_size,
      lobe_size * lobes * lobe_slices,
      {"lean", "width", "weight"},
      "x sqrt(cos theta), y sqrt(alpha), nodes at i / (size - 1); below each other the share "
      "of Schlick's edge, 0 to 1; every slice holds the lobes below each other, narrowest first",
      -2.0f,
      64.0f};
}

} // namespace

CellAxes energy_axes(int x, int y) {
  return {std::pow(x / (energy_size - 1.0), 2.0), std::pow(y / (energy_size - 1.0), 2.0), 0.0};
}

CellAxes lobe_axes(int x, int y, int slice) {
  return {std::pow(x / (lobe_size - 1.0), 2.0), std::pow(y / (lobe_size - 1.0), 2.0),
          slice / (lobe_slices - 1.0)};
}

void write(const std::filesystem::path& directory, const ReflectionEnergyTable& table) {
  write_table(directory, energy_layout(), table.model, table.texels);
}

void write(const std::filesystem::path& directory, const ReflectionLobeTable& table) {
  write_table(directory, lobe_layout(table.lobes), table.model, table.texels);
}

ReflectionEnergyTable read_reflection_energy(const std::filesystem::path& directory,
                                             const Model& model) {
  return {model, read_table(directory, energy_layout(), model)};
}

ReflectionLobeTable read_reflection_lobes(const std::filesystem::path& directory,
                                          const Model& model, int lobes) {
  return {model, lobes, read_table(directory, lobe_layout(lobes), model)};
}

} // namespace gg::tables
