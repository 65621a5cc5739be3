// Buffers, textures and samplers.
#pragma once

#include "gpu/types.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/tracker.h"

#include <memory>
#include <span>
#include <vector>

namespace gg::gpu::vulkan {

struct GpuBuffer final : Buffer {
  GpuBuffer(std::shared_ptr<Context> owner, const BufferDesc& what);
  ~GpuBuffer() override;

  std::shared_ptr<Context> context;
  std::uint64_t serial = 0; // never another object's (Context::next_serial)
  VkBuffer handle = VK_NULL_HANDLE;
  Allocation memory;
  State state;
  // The last batch of copies that wrote to it, and the bytes that it wrote (transfers.h).
  std::uint64_t copy_batch = 0;
  std::size_t copied_begin = 0, copied_end = 0;
};

// A range of subresources. The slices of a volume are no subresources: they share one.
struct Range {
  std::uint32_t level = 0, level_count = 1, layer = 0, layer_count = 1;
};

struct GpuTexture final : Texture {
  GpuTexture(std::shared_ptr<Context> owner, const TextureDesc& what);
  ~GpuTexture() override;

  // The subresources of a view of this texture. Throws Error(internal) if it has no such.
  Range range_of(const View& view) const;
  struct Seen {
    VkImageView handle = VK_NULL_HANDLE;
    std::uint64_t serial = 0;
  };
  // As a shader that declares `shape` sees it, which has been checked; made at first use and kept.
  Seen view(const View& view, Shape shape);
  VkImageView attachment(const View& view); // one level of one layer, face or slice

  State& state(std::uint32_t level, std::uint32_t layer) {
    return states_[level * layers_ + layer];
  }
  Range all() const { return {0, static_cast<std::uint32_t>(desc.levels), 0, layers_}; }

  std::shared_ptr<Context> context;
  VkImage handle = VK_NULL_HANDLE;
  Allocation memory;
  bool settling = false; // waits in Transfers to be made readable by shaders

private:
  struct CachedView {
    VkImageViewType type;
    Range range;
    Seen seen;
  };
  Seen find_or_make(VkImageViewType type, const Range& range);

  std::uint32_t layers_ = 1;
  std::vector<State> states_; // [level][layer]
  std::vector<CachedView> views_;
};

struct GpuSampler final : Sampler {
  GpuSampler(std::shared_ptr<Context> owner, const SamplerDesc& what);
  ~GpuSampler() override;

  std::shared_ptr<Context> context;
  std::uint64_t serial = 0; // never another object's
  VkSampler handle = VK_NULL_HANDLE;
};

// What the interface's objects are here.
inline GpuBuffer& of(const BufferRef& buffer) {
  return static_cast<GpuBuffer&>(*buffer);
}
inline GpuTexture& of(const TextureRef& texture) {
  return static_cast<GpuTexture&>(*texture);
}
inline GpuSampler& of(const SamplerRef& sampler) {
  return static_cast<GpuSampler&>(*sampler);
}

} // namespace gg::gpu::vulkan
