// Uploads, read-back and reduction to smaller levels.
#pragma once

#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/commands.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace gg::gpu::vulkan {

// Copies are recorded in batches: the first waits for all passes before it, and the passes after it
// wait for all of them. What was uploaded can therefore be read by any pass without being declared;
// only what passes themselves write has to be.
class Transfers {
public:
  Transfers(Context& context, Commands& commands);

  void upload(GpuBuffer& buffer, std::size_t offset, std::span<const std::byte> bytes);
  void clear(GpuBuffer& buffer); // to zeros
  void upload(const std::shared_ptr<GpuTexture>& texture, int level, int layer,
              std::span<const std::byte> texels);
  void generate_mipmaps(const std::shared_ptr<GpuTexture>& texture);
  std::vector<std::byte> read(GpuBuffer& buffer, std::size_t offset, std::size_t bytes);
  std::vector<std::byte> read(const std::shared_ptr<GpuTexture>& texture, int level, int layer);

  // When the batch ends, the texture can be sampled without being declared; levels that nobody has
  // written hold zeros then. For textures that are sampled.
  void settle_later(const std::shared_ptr<GpuTexture>& texture);
  // Ends the batch: what it touched can be read by shaders. Passes may follow.
  void settle();

private:
  VkCommandBuffer begin_copies();
  HostBuffer& read_back_buffer(std::size_t bytes);
  std::vector<std::byte> wait_for(const HostBuffer& from, std::size_t bytes);

  Context& context_;
  Commands& commands_;
  Barriers barriers_;
  bool copying_ = false;
  std::uint64_t batch_ = 0;
  std::vector<std::shared_ptr<GpuTexture>> unsettled_;
  std::unique_ptr<HostBuffer> read_back_;
};

} // namespace gg::gpu::vulkan
