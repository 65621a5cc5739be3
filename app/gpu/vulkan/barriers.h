// Barriers and layouts, derived from what is going to be done with which resources.
#pragma once

#include "gpu/vulkan/resources.h"
#include "gpu/vulkan/tracker.h"

#include <vector>

namespace gg::gpu::vulkan {

// What passes and copies do with resources.
inline constexpr VkPipelineStageFlags2 drawing_stages =
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
inline constexpr VkPipelineStageFlags2 computing_stages = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;

Access sampled_by(VkPipelineStageFlags2 stages);
Access stored_by(VkPipelineStageFlags2 stages); // storage images: read, written and sampled
Access color_target(bool overwrites);
Access depth_target(bool overwrites);
Access copied_from();
Access copied_to(bool overwrites);
Access buffer_read(bool draws);    // as storage, uniforms, vertices or indices
Access buffer_written(bool draws); // by shaders, that may read it too

// Collects what a step needs, and issues it as one command.
class Barriers {
public:
  explicit Barriers(const Context& context) : context_(context) {}

  // Orders `access` to a range behind what was done with it before. Subresources that nobody has
  // written yet hold zeros: they are cleared first unless the access overwrites them.
  void add(VkCommandBuffer commands, GpuTexture& texture, const Range& range, const Access& access);
  void add(GpuBuffer& buffer, const Access& access);
  void add_memory(VkPipelineStageFlags2 source_stages, VkAccessFlags2 source_access,
                  VkPipelineStageFlags2 stages, VkAccessFlags2 access);
  void issue(VkCommandBuffer commands);

private:
  void add(GpuTexture& texture, std::uint32_t level, std::uint32_t layer, const Access& access);
  void clear_undefined(VkCommandBuffer commands, GpuTexture& texture, const Range& range);

  const Context& context_;
  std::vector<VkImageMemoryBarrier2> images_;
  std::vector<VkBufferMemoryBarrier2> buffers_;
  std::vector<VkMemoryBarrier2> memory_;
};

// True if the buffer can be accessed now, without a barrier; it then counts as accessed.
bool is_ready(GpuBuffer& buffer, const Access& access);

} // namespace gg::gpu::vulkan
