// The tables on the device.
#pragma once

#include "gpu/device.h"
#include "tables/lobe.h"

#include <array>

namespace gg::tables {

// What shaders/environment/lobe_table_fetch.glsl, refraction/interface_table_fetch.glsl and refraction/thin_wall_table_fetch.glsl
// read, for one model.
struct ModelTables {
  gpu::TextureRef energy;           // sampler2D
  gpu::TextureRef lobe;             // sampler3D
  gpu::TextureRef interface_energy; // sampler3D; null unless asked for
  gpu::TextureRef interface_lobes;  // sampler3D
  gpu::TextureRef wall_energy;      // sampler3D; null unless asked for
  gpu::TextureRef wall_lobes;       // sampler3D
};

struct DeviceTables {
  std::array<ModelTables, models.size()> of_model; // in the order of `models`
  gpu::SamplerRef sampler;                         // for all of them
  const ModelTables& of(const Model& model) const;
};

// No tables yet, and the sampler for all.
DeviceTables make_tables(gpu::Device& device);

// Reads assets/tables and adds the tables of a model's reflection, of so many lobes (1 to 4). Throws Error(input) if a file is
// missing or damaged.
void upload_reflection(gpu::Device& device, DeviceTables& tables, const Model& model, int lobes);

// Adds the tables of what is transmitted, of so many lobes (1 to 4), for these models.
void upload_interfaces(gpu::Device& device, DeviceTables& tables, std::span<const Model> wanted,
                       int lobes);

// Adds the tables of a model's thin walls, of 1 or 2 lobes.
void upload_thin_walls(gpu::Device& device, DeviceTables& tables, const Model& model, int lobes);

} // namespace gg::tables
