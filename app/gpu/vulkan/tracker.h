// Which barrier an access needs, worked out from the accesses before it. A pure state machine: one
// State per subresource of an image and per buffer, kept across submissions, because all of them go
// to one queue and a barrier orders everything submitted before it.
#pragma once

#include "gpu/vulkan/api.h"

#include <optional>

namespace gg::gpu::vulkan {

// What is about to be done with a resource. Buffers have no layout: VK_IMAGE_LAYOUT_UNDEFINED.
struct Access {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool writes = false;
  bool overwrites = false; // all of it: what was there before is not needed
};

// What has been done with it.
struct State {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkPipelineStageFlags2 write_stages = 0; // of the last write or change of layout
  VkAccessFlags2 write_access = 0;        // 0 for a change of layout, which makes itself available
  VkPipelineStageFlags2 visible_stages = 0; // which that write has been made visible to,
  VkAccessFlags2 visible_access = 0;        // and for what
  VkPipelineStageFlags2 read_stages = 0;    // that read since
};

struct Barrier {
  VkPipelineStageFlags2 source_stages = 0;
  VkAccessFlags2 source_access = 0;
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;
  VkImageLayout from = VK_IMAGE_LAYOUT_UNDEFINED, to = VK_IMAGE_LAYOUT_UNDEFINED;
  bool operator==(const Barrier&) const = default;
};

// The barrier that `access` must wait behind, if any, and the state after it.
std::optional<Barrier> advance(State& state, const Access& access);

} // namespace gg::gpu::vulkan
