// Checks of descriptions and requests that are the same for every backend, so that a fault reads
// the same everywhere and no driver sees it. Implementation of app/gpu.
#pragma once

#include "gpu/device.h"
#include "gpu/shaders/module.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace gg::gpu {

// What a device can do at most.
struct Limits {
  int texture_2d = 0, texture_3d = 0, texture_cube = 0; // texels along an edge
  int array_layers = 0;
  std::size_t uniform_bytes = 0, storage_bytes = 0; // of one block
  unsigned groups = 0;                              // of a dispatch, along each axis
  int attachments = 0;
};

// "texture 'name' (1024 x 512, 3 levels)", for messages.
std::string describe(const BufferDesc& desc);
std::string describe(const TextureDesc& desc);
std::string describe(const SamplerDesc& desc); // "linear, repeat", as its label

// Throw Error(internal) for what is wrong on every device, Error(device) for what is too large for
// this one.
void check(const BufferDesc& desc, std::span<const std::byte> contents, const Limits& limits);
void check(const TextureDesc& desc, const Limits& limits);
void check(const PipelineDesc& desc, const Limits& limits);
void check_range(const BufferDesc& desc, std::size_t offset, std::size_t bytes);
// One level and layer, and the size of the texels for it where `bytes` is given.
void check_part(const TextureDesc& desc, int level, int layer);
void check_texels(const TextureDesc& desc, int level, int layer, std::size_t bytes);
void check_view(const View& view);
// The view as what a shader calls `binding`.
void check_bound(const View& view, const shaders::Binding& binding, const std::string& pipeline);
// Targets that exist, have one size and one layer each, and record something.
void check(const Pass& pass, const Limits& limits);
// The size of what a drawing pass draws into.
Extent target_extent(const Pass& pass);
// That a pass that draws into these targets may use the pipeline.
void check_targets(const PipelineDesc& desc, const Pass& pass);
void check_dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z, const Limits& limits,
                    const std::string& pipeline);

// That a resource which passes write is declared by the pass that uses it: declarations are all
// that a backend orders passes by.
void check_declared(const Pass& pass, const View& view, bool storage);
void check_declared(const Pass& pass, const BufferRef& buffer, bool writes);

} // namespace gg::gpu
