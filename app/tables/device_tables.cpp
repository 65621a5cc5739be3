#include "tables/device_tables.h"

#include "core/files.h"
#include "glsl/f32.h"
#include "tables/interface_table.h"
#include "tables/reflection_table.h"
#include "tables/thin_wall_table.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>

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

// `texels` RGBA, slices one after the other.
gpu::TextureRef upload_volume(gpu::Device& device, const std::string& label, int width, int height,
                              int slices, std::span<const float> texels) {
  const gpu::TextureRef texture = device.create(gpu::TextureDesc{.label = label,
                                                                 .shape = gpu::Shape::d3,
                                                                 .format = gpu::Format::rgba16f,
                                                                 .width = width,
                                                                 .height = height,
                                                                 .layers = slices});
  const std::vector<std::uint16_t> values = halves(texels);
  const std::size_t slice = values.size() / static_cast<std::size_t>(slices);
  for (int k = 0; k < slices; ++k)
    device.upload(
        texture, 0, k,
        std::as_bytes(std::span(values).subspan(slice * static_cast<std::size_t>(k), slice)));
  return texture;
}

} // namespace

const ModelTables& DeviceTables::of(const Model& model) const {
  return of_model[index_of(model)];
}

DeviceTables make_tables(gpu::Device& device) {
  DeviceTables tables;
  tables.sampler = device.create(gpu::SamplerDesc{});
  return tables;
}

void upload_reflection(gpu::Device& device, DeviceTables& tables, const Model& model, int lobes) {
  const std::filesystem::path directory = home_directory() / "assets" / "tables";
  ModelTables& target = tables.of_model[index_of(model)];
  constexpr int energy_size = glsl::f32::ENERGY_TABLE_SIZE, size = glsl::f32::LOBE_TABLE_SIZE;
  target.energy = device.create(gpu::TextureDesc{.label = "energy " + name(model),
                                                 .format = gpu::Format::rgba16f,
                                                 .width = energy_size,
                                                 .height = energy_size});
  const std::vector<std::uint16_t> energy = halves(read_reflection_energy(directory, model).texels);
  device.upload(target.energy, 0, 0, std::as_bytes(std::span(energy)));
  target.lobe =
      upload_volume(device, "lobe " + name(model), size, size * lobes, glsl::f32::LOBE_TABLE_SLICES,
                    read_reflection_lobes(directory, model, lobes).texels);
}

void upload_interfaces(gpu::Device& device, DeviceTables& tables, std::span<const Model> wanted,
                       int lobes) {
  namespace f32 = glsl::f32;
  const std::filesystem::path directory = home_directory() / "assets" / "tables";
  for (const Model& model : wanted) {
    ModelTables& target = tables.of_model[index_of(model)];
    target.interface_energy =
        upload_volume(device, "interface energy " + name(model), f32::INTERFACE_ENERGY_COSINES,
                      f32::INTERFACE_ENERGY_ALPHAS, 2 * f32::INTERFACE_SLICES,
                      read_interface_energy(directory, model).texels);
    target.interface_lobes =
        upload_volume(device, "interface lobes " + name(model), f32::INTERFACE_LOBE_COSINES,
                      lobes * f32::INTERFACE_LOBE_ALPHAS, 2 * f32::INTERFACE_SLICES,
                      read_interface_lobes(directory, model, lobes).texels);
  }
}

void upload_thin_walls(gpu::Device& device, DeviceTables& tables, const Model& model, int lobes) {
  namespace f32 = glsl::f32;
  const std::filesystem::path directory = home_directory() / "assets" / "tables";
  const auto upload = [&](const char* what, int of_lobes) {
    return upload_volume(device, what + name(model), f32::THIN_WALL_COSINES,
                         std::max(of_lobes, 1) * f32::THIN_WALL_ALPHAS, f32::THIN_WALL_SLICES,
                         read_thin_wall(directory, model, of_lobes).texels);
  };
  ModelTables& target = tables.of_model[index_of(model)];
  target.wall_energy = upload("thin wall energy ", 0);
  target.wall_lobes = upload("thin wall lobes ", lobes);
}

} // namespace gg::tables
