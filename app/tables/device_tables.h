// The tables on the device.
#pragma once

#include "gpu/device.h"
#include "tables/lobe.h"

#include <array>

namespace gg::tables {

// What shaders/environment/lobe_table_fetch.glsl reads, for one model.
struct ModelTables {
  gpu::TextureRef energy; // sampler2D
  gpu::TextureRef lobe;   // sampler3D
};

struct DeviceTables {
  std::array<ModelTables, models.size()> of_model; // in the order of `models`
  gpu::SamplerRef sampler;                         // for all of them
  const ModelTables& of(const Model& model) const;
};

// Reads assets/tables and uploads the tables of the models asked for; those of the others stay empty. Throws
// Error(input) if a file is missing or damaged.
DeviceTables upload(gpu::Device& device, std::span<const Model> wanted = models);

} // namespace gg::tables
