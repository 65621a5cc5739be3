#include "gpu/checked_device.h"

#include "core/error.h"
#include "gpu/shaders/compile.h"

#include <algorithm>
#include <array>

namespace gg::gpu {
namespace {

template <class Object>
const Object& require(const std::shared_ptr<Object>& object, const char* doing) {
  if (!object) throw Error(ExitCode::internal, doing, "is given nothing");
  return *object;
}

} // namespace

BufferRef CheckedDevice::create(const BufferDesc& desc, std::span<const std::byte> contents) {
  check(desc, contents, limits_);
  return make(desc, contents);
}

TextureRef CheckedDevice::create(const TextureDesc& desc) {
  check(desc, limits_);
  return make(desc);
}

SamplerRef CheckedDevice::create(const SamplerDesc& desc) {
  const auto known =
      std::ranges::find_if(samplers_, [&](const SamplerRef& s) { return s->desc == desc; });
  return known != samplers_.end() ? *known : samplers_.emplace_back(make(desc));
}

PipelineRef CheckedDevice::create(const PipelineDesc& desc) {
  check(desc, limits_);
  return make(desc);
}

PipelineRef CheckedDevice::create(const ComputeDesc& desc) {
  return make(desc);
}

void CheckedDevice::expect(std::span<const PipelineDesc> pipelines) {
  for (const PipelineDesc& desc : pipelines)
    shaders::link_ahead(desc.label, std::array{desc.vertex, desc.fragment}, desc.constants,
                        backend_);
}

void CheckedDevice::expect(std::span<const ComputeDesc> pipelines) {
  for (const ComputeDesc& desc : pipelines)
    shaders::link_ahead(desc.label, std::array{desc.compute}, desc.constants, backend_);
}

void CheckedDevice::upload(const TextureRef& texture, int level, int layer,
                           std::span<const std::byte> texels) {
  check_texels(require(texture, "an upload").desc, level, layer, texels.size());
  fill(texture, level, layer, texels);
}

void CheckedDevice::upload(const BufferRef& buffer, std::size_t offset,
                           std::span<const std::byte> bytes) {
  check_range(require(buffer, "an upload").desc, offset, bytes.size());
  if (!bytes.empty()) fill(buffer, offset, bytes);
}

void CheckedDevice::generate_mipmaps(const TextureRef& texture) {
  require(texture, "making mip levels");
  fill_levels(texture);
}

std::vector<std::byte> CheckedDevice::read(const TextureRef& texture, int level, int layer) {
  check_part(require(texture, "reading back").desc, level, layer);
  return fetch(texture, level, layer);
}

std::vector<std::byte> CheckedDevice::read(const BufferRef& buffer, std::size_t offset,
                                           std::size_t bytes) {
  check_range(require(buffer, "reading back").desc, offset, bytes);
  return bytes ? fetch(buffer, offset, bytes) : std::vector<std::byte>();
}

} // namespace gg::gpu
