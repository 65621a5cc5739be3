#include "gpu/vulkan/barriers.h"

#include "gpu/vulkan/formats.h"

namespace gg::gpu::vulkan {

Access sampled_by(VkPipelineStageFlags2 stages) {
  return {.stages = stages,
          .access = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
          .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

Access stored_by(VkPipelineStageFlags2 stages) {
  return {.stages = stages,
          .access = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT
                    | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
          .layout = VK_IMAGE_LAYOUT_GENERAL,
          .writes = true};
}

Access color_target(bool overwrites) {
  return {.stages = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
          .access = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
          .layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
          .writes = true,
          .overwrites = overwrites};
}

Access depth_target(bool overwrites) {
  return {.stages = VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT
                    | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
          .access = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT
                    | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
          .layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
          .writes = true,
          .overwrites = overwrites};
}

Access copied_from() {
  return {.stages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
          .access = VK_ACCESS_2_TRANSFER_READ_BIT,
          .layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
}

Access copied_to(bool overwrites) {
  return {.stages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
          .access = VK_ACCESS_2_TRANSFER_WRITE_BIT,
          .layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
          .writes = true,
          .overwrites = overwrites};
}

Access buffer_read(bool draws) {
  if (!draws)
    return {.stages = computing_stages,
            .access = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT};
  return {.stages = drawing_stages | VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT,
          .access = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT
                    | VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT};
}

Access buffer_written(bool draws) {
  return {.stages = draws ? drawing_stages : computing_stages,
          .access = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
          .writes = true};
}

void Barriers::add(GpuTexture& texture, std::uint32_t level, std::uint32_t layer,
                   const Access& access) {
  const auto barrier = advance(texture.state(level, layer), access);
  if (!barrier) return;
  VkImageMemoryBarrier2 next{
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
      .srcStageMask = barrier->source_stages,
      .srcAccessMask = barrier->source_access,
      .dstStageMask = barrier->stages,
      .dstAccessMask = barrier->access,
      .oldLayout = barrier->from,
      .newLayout = barrier->to,
      .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .image = texture.handle,
      .subresourceRange = {aspect_of(texture.desc.format), level, 1, layer, 1}};
  // Neighbouring layers mostly share a history: one barrier for them.
  if (!images_.empty()) {
    VkImageMemoryBarrier2& last = images_.back();
    VkImageSubresourceRange& range = last.subresourceRange;
    if (last.image == next.image && last.srcStageMask == next.srcStageMask
        && last.srcAccessMask == next.srcAccessMask && last.dstStageMask == next.dstStageMask
        && last.dstAccessMask == next.dstAccessMask && last.oldLayout == next.oldLayout
        && last.newLayout == next.newLayout && range.baseMipLevel == level && range.levelCount == 1
        && range.baseArrayLayer + range.layerCount == layer) {
      ++range.layerCount;
      return;
    }
  }
  images_.push_back(next);
}

void Barriers::clear_undefined(VkCommandBuffer commands, GpuTexture& texture, const Range& range) {
  std::vector<VkImageSubresourceRange> empty;
  for (std::uint32_t level = range.level; level < range.level + range.level_count; ++level)
    for (std::uint32_t layer = range.layer; layer < range.layer + range.layer_count; ++layer)
      if (texture.state(level, layer).layout == VK_IMAGE_LAYOUT_UNDEFINED) {
        add(texture, level, layer, copied_to(true));
        empty.push_back({aspect_of(texture.desc.format), level, 1, layer, 1});
      }
  if (empty.empty()) return;
  issue(commands);
  const auto count = static_cast<std::uint32_t>(empty.size());
  if (texture.desc.format == Format::depth32f) {
    const VkClearDepthStencilValue zero{};
    context_.vk().CmdClearDepthStencilImage(
        commands, texture.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &zero, count, empty.data());
  } else {
    const VkClearColorValue zero{};
    context_.vk().CmdClearColorImage(commands, texture.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                     &zero, count, empty.data());
  }
}

void Barriers::add(VkCommandBuffer commands, GpuTexture& texture, const Range& range,
                   const Access& access) {
  // A slice of a volume is a part of its subresource: the other slices must stay.
  Access adjusted = access;
  if (texture.desc.shape == Shape::d3
      && extent_of(texture.desc, static_cast<int>(range.level)).depth > 1)
    adjusted.overwrites = false;
  if (!adjusted.overwrites) clear_undefined(commands, texture, range);
  for (std::uint32_t level = range.level; level < range.level + range.level_count; ++level)
    for (std::uint32_t layer = range.layer; layer < range.layer + range.layer_count; ++layer)
      add(texture, level, layer, adjusted);
}

void Barriers::add(GpuBuffer& buffer, const Access& access) {
  const auto barrier = advance(buffer.state, access);
  if (!barrier) return;
  buffers_.push_back({.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                      .srcStageMask = barrier->source_stages,
                      .srcAccessMask = barrier->source_access,
                      .dstStageMask = barrier->stages,
                      .dstAccessMask = barrier->access,
                      .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                      .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                      .buffer = buffer.handle,
                      .size = VK_WHOLE_SIZE});
}

void Barriers::add_memory(VkPipelineStageFlags2 source_stages, VkAccessFlags2 source_access,
                          VkPipelineStageFlags2 stages, VkAccessFlags2 access) {
  memory_.push_back({.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                     .srcStageMask = source_stages,
                     .srcAccessMask = source_access,
                     .dstStageMask = stages,
                     .dstAccessMask = access});
}

void Barriers::issue(VkCommandBuffer commands) {
  if (images_.empty() && buffers_.empty() && memory_.empty()) return;
  const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                              .memoryBarrierCount = static_cast<std::uint32_t>(memory_.size()),
                              .pMemoryBarriers = memory_.data(),
                              .bufferMemoryBarrierCount =
                                  static_cast<std::uint32_t>(buffers_.size()),
                              .pBufferMemoryBarriers = buffers_.data(),
                              .imageMemoryBarrierCount = static_cast<std::uint32_t>(images_.size()),
                              .pImageMemoryBarriers = images_.data()};
  context_.vk().CmdPipelineBarrier2(commands, &info);
  memory_.clear();
  buffers_.clear();
  images_.clear();
}

bool is_ready(GpuBuffer& buffer, const Access& access) {
  State after = buffer.state;
  if (advance(after, access)) return false;
  buffer.state = after;
  return true;
}

} // namespace gg::gpu::vulkan
