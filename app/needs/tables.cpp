#include "needs/tables.h"

#include "glsl/f32.h"

#include <algorithm>

namespace gg::needs {
namespace {

namespace f32 = glsl::f32;

constexpr std::size_t texel = 8; // bytes: four half floats

Table table_of(TableKind kind, const tables::Model& model, int lobes) {
  const std::string of_model = tables::name(model) + ".exr",
                    of_lobes = "lobes" + std::to_string(lobes);
  Table table{.kind = kind, .model = model};
  switch (kind) {
  case TableKind::reflection_energy:
    table.file = "reflection-energy-" + of_model;
    table.bytes = texel * f32::ENERGY_TABLE_SIZE * f32::ENERGY_TABLE_SIZE;
    break;
  case TableKind::reflection_lobes:
    table.lobes = lobes;
    table.file = "reflection-" + of_lobes + "-" + of_model;
    table.bytes = texel * f32::LOBE_TABLE_SIZE * f32::LOBE_TABLE_SIZE * f32::LOBE_TABLE_SLICES;
    break;
  case TableKind::interface_energy:
    table.file = "interface-energy-" + of_model;
    table.bytes = texel * f32::INTERFACE_ENERGY_COSINES * f32::INTERFACE_ENERGY_ALPHAS * 2
                  * f32::INTERFACE_SLICES;
    break;
  case TableKind::interface_lobes:
    table.lobes = lobes;
    table.file = "interface-" + of_lobes + "-" + of_model;
    table.bytes = texel * f32::INTERFACE_LOBE_COSINES * f32::INTERFACE_LOBE_ALPHAS * 2
                  * f32::INTERFACE_SLICES;
    break;
  case TableKind::wall_energy:
  case TableKind::wall_lobes:
    table.lobes = lobes;
    table.file =
        (lobes ? "thin-wall-" + of_lobes : std::string("thin-wall-energy")) + "-" + of_model;
    table.bytes = texel * f32::THIN_WALL_COSINES * f32::THIN_WALL_ALPHAS * f32::THIN_WALL_SLICES;
    break;
  }
  if (lobes > 1) table.bytes *= static_cast<std::size_t>(lobes);
  return table;
}

bool same(const tables::Model& a, const tables::Model& b) {
  return a.distribution == b.distribution && a.smith == b.smith;
}

} // namespace

tables::Model model_of(const scene::Material& material, bool correlated_smith) {
  switch (material.distribution) {
  case scene::Distribution::ggx:
    return {tables::Distribution::ggx,
            correlated_smith ? tables::Smith::correlated : tables::Smith::separable};
  case scene::Distribution::beckmann:
    return {tables::Distribution::beckmann, tables::Smith::separable};
  case scene::Distribution::phong:
    return {tables::Distribution::phong, tables::Smith::separable};
  }
  return {};
}

int reflection_lobes(Method method, const tables::Model& model) {
  return std::clamp(lobes_of(method), 1, tables::lobes_of(model)); // Phong has two
}

int interface_lobes(Method method) {
  if (method == Method::standard) return 0;
  // Importance sampling takes energies and widths of what it does not sample from the same tables.
  return lobes_of(method) > 1 ? 2 : 1;
}

std::vector<Table> tables_of(const std::vector<Draw>& draws, const View& view) {
  std::vector<Table> tables;
  for (const tables::Model& model : tables::models) {
    bool reflects = false, transmits = false, has_walls = false;
    for (const Draw& draw : draws) {
      if (!same(model_of(*draw.material, view.correlated_smith), model)) continue;
      if (value_of(draw.key, Feature::smooth) != 0) continue;
      const bool lit = value_of(draw.key, Feature::shading) != static_cast<int>(Shading::unlit);
      reflects = reflects || (lit && value_of(draw.key, Feature::lobe_count) != 0);
      if (draw.role != Role::refractive || draw.is_straight()) continue;
      (draw.is_solid() ? transmits : has_walls) = true;
    }
    if (reflects) {
      tables.push_back(table_of(TableKind::reflection_energy, model, 0));
      tables.push_back(
          table_of(TableKind::reflection_lobes, model, reflection_lobes(view.method, model)));
    }
    if (transmits && interface_lobes(view.method) > 0) {
      tables.push_back(table_of(TableKind::interface_energy, model, 0));
      tables.push_back(table_of(TableKind::interface_lobes, model, interface_lobes(view.method)));
    }
    if (has_walls && interface_lobes(view.method) > 0) {
      tables.push_back(table_of(TableKind::wall_energy, model, 0));
      tables.push_back(table_of(TableKind::wall_lobes, model, interface_lobes(view.method)));
    }
  }
  return tables;
}

} // namespace gg::needs
