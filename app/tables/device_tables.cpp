#include "tables/device_tables.h"

#include "core/files.h"
#include "glsl/f32.h"
#include "tables/reflection_table.h"

#include <glm/gtc/packing.hpp>

namespace gg::tables {
namespace {

std::vector<std::uint16_t> halves(std::span<const float> values) {
  std::vector<std::uint16_t> result;
  result.reserve(values.size());
  for (float v : values)
    result.push_back(glm::packHalf1x16(v)); // exact: the files hold half floats
  return result;
}

std::size_t index_of(const Model& model) {
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].distribution == model.distribution && models[i].smith == model.smith) return i;
  // Beckmann and Phong have one masking, Walter's.
  return index_of({model.distribution, Smith::separable});
}

} // namespace

const ModelTables& DeviceTables::of(const Model& model) const {
  return of_model[index_of(model)];
}

DeviceTables upload(gpu::Device& device, std::span<const Model> wanted) {
  DeviceTables tables;
  tables.sampler = device.create(gpu::SamplerDesc{});
  for (const Model& model : wanted) {
    const ReflectionTable table = read(home_directory() / "assets" / "tables", model);
    ModelTables& target = tables.of_model[index_of(model)];
    constexpr int energy_size = glsl::f32::ENERGY_TABLE_SIZE, size = glsl::f32::LOBE_TABLE_SIZE;
    target.energy = device.create(gpu::TextureDesc{.label = "energy " + name(model),
                                                   .format = gpu::Format::rgba16f,
                                                   .width = energy_size,
                                                   .height = energy_size});
    const std::vector<std::uint16_t> energy = halves(table.energy), lobe = halves(table.lobe);
    device.upload(target.energy, 0, 0, std::as_bytes(std::span(energy)));
    target.lobe = device.create(gpu::TextureDesc{.label = "lobe " + name(model),
                                                 .shape = gpu::Shape::d3,
                                                 .format = gpu::Format::rgba16f,
                                                 .width = size,
                                                 .height = size,
                                                 .layers = glsl::f32::LOBE_TABLE_SLICES});
    constexpr std::size_t slice = 4 * static_cast<std::size_t>(size) * size;
    for (int k = 0; k < glsl::f32::LOBE_TABLE_SLICES; ++k)
      device.upload(
          target.lobe, 0, k,
          std::as_bytes(std::span(lobe).subspan(slice * static_cast<std::size_t>(k), slice)));
  }
  return tables;
}

} // namespace gg::tables
