#include "gpu/vulkan/transfers.h"

#include "gpu/vulkan/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace gg::gpu::vulkan {

namespace {

VkImageSubresourceLayers subresource(const GpuTexture& texture, int level, int layer) {
  const bool volume = texture.desc.shape == Shape::d3;
  return {aspect_of(texture.desc.format), static_cast<std::uint32_t>(level),
          volume ? 0 : static_cast<std::uint32_t>(layer), 1};
}

Range range_of(const GpuTexture& texture, int level, int layer) {
  const bool volume = texture.desc.shape == Shape::d3;
  return {static_cast<std::uint32_t>(level), 1, volume ? 0 : static_cast<std::uint32_t>(layer), 1};
}

// Rows tightly packed, row 0 first: Vulkan's own order.
VkBufferImageCopy2 whole_layer(const GpuTexture& texture, int level, int layer,
                               VkDeviceSize offset) {
  VkExtent3D extent = extent_of(texture.desc, level);
  extent.depth = 1;
  return {.sType = VK_STRUCTURE_TYPE_BUFFER_IMAGE_COPY_2,
          .bufferOffset = offset,
          .imageSubresource = subresource(texture, level, layer),
          .imageOffset = {0, 0, texture.desc.shape == Shape::d3 ? layer : 0},
          .imageExtent = extent};
}

} // namespace

Transfers::Transfers(Context& context, Commands& commands)
    : context_(context), commands_(commands), barriers_(context) {}

VkCommandBuffer Transfers::begin_copies() {
  if (commands_.is_full()) {
    settle();
    commands_.submit();
  }
  const VkCommandBuffer commands = commands_.open();
  if (copying_) return commands;
  copying_ = true;
  ++batch_;
  barriers_.add_memory(VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                       VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                       VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
  barriers_.issue(commands);
  return commands;
}

void Transfers::settle_later(const std::shared_ptr<GpuTexture>& texture) {
  if (texture->settling || !has(texture->desc.use, Use::sampled)) return;
  begin_copies();
  texture->settling = true;
  unsettled_.push_back(texture);
}

void Transfers::settle() {
  if (!copying_) return;
  const VkCommandBuffer commands = commands_.open();
  for (const auto& texture : unsettled_) {
    barriers_.add(commands, *texture, texture->all(),
                  sampled_by(drawing_stages | computing_stages));
    texture->settling = false;
  }
  unsettled_.clear();
  barriers_.add_memory(VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                       VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                       VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
  barriers_.issue(commands);
  copying_ = false;
}

void Transfers::upload(GpuBuffer& buffer, std::size_t offset, std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  const VkCommandBuffer commands = begin_copies();
  const std::size_t end = offset + bytes.size();
  if (buffer.copy_batch != batch_) {
    buffer.copy_batch = batch_;
    buffer.copied_begin = offset, buffer.copied_end = end;
  } else {
    if (offset < buffer.copied_end && buffer.copied_begin < end) { // the later copy must win
      barriers_.add_memory(VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                           VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
      barriers_.issue(commands);
    }
    buffer.copied_begin = std::min(buffer.copied_begin, offset);
    buffer.copied_end = std::max(buffer.copied_end, end);
  }
  buffer.state = {}; // the batch is waited for as a whole

  const Staged staged = commands_.stage(bytes.size());
  std::memcpy(staged.mapped, bytes.data(), bytes.size());
  const VkBufferCopy2 region{.sType = VK_STRUCTURE_TYPE_BUFFER_COPY_2,
                             .srcOffset = staged.offset,
                             .dstOffset = offset,
                             .size = bytes.size()};
  const VkCopyBufferInfo2 copy{.sType = VK_STRUCTURE_TYPE_COPY_BUFFER_INFO_2,
                               .srcBuffer = staged.buffer,
                               .dstBuffer = buffer.handle,
                               .regionCount = 1,
                               .pRegions = &region};
  context_.vk().CmdCopyBuffer2(commands, &copy);
}

void Transfers::clear(GpuBuffer& buffer) {
  const VkCommandBuffer commands = begin_copies();
  context_.vk().CmdFillBuffer(commands, buffer.handle, 0, VK_WHOLE_SIZE, 0);
  buffer.copy_batch = batch_;
  buffer.copied_begin = 0, buffer.copied_end = buffer.desc.bytes;
}

void Transfers::upload(const std::shared_ptr<GpuTexture>& texture, int level, int layer,
                       std::span<const std::byte> texels) {
  const Range range = range_of(*texture, level, layer);
  const VkCommandBuffer commands = begin_copies();
  barriers_.add(commands, *texture, range, copied_to(true));
  barriers_.issue(commands);
  settle_later(texture);

  const Staged staged = commands_.stage(texels.size());
  std::memcpy(staged.mapped, texels.data(), texels.size());
  const VkBufferImageCopy2 region = whole_layer(*texture, level, layer, staged.offset);
  const VkCopyBufferToImageInfo2 copy{.sType = VK_STRUCTURE_TYPE_COPY_BUFFER_TO_IMAGE_INFO_2,
                                      .srcBuffer = staged.buffer,
                                      .dstImage = texture->handle,
                                      .dstImageLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                      .regionCount = 1,
                                      .pRegions = &region};
  context_.vk().CmdCopyBufferToImage2(commands, &copy);
}

void Transfers::generate_mipmaps(const std::shared_ptr<GpuTexture>& texture) {
  const TextureDesc& desc = texture->desc;
  if (desc.levels < 2) return;
  constexpr VkFormatFeatureFlags needed = VK_FORMAT_FEATURE_BLIT_SRC_BIT
                                          | VK_FORMAT_FEATURE_BLIT_DST_BIT
                                          | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  if ((context_.features_of(format_of(desc.format)) & needed) != needed)
    throw Error(ExitCode::device, "vulkan",
                fmt::format("the device cannot filter the format (VkFormat {}) of the texture '{}' "
                            "to make its smaller levels",
                            static_cast<int>(format_of(desc.format)), desc.label),
                "Choose another --device or --backend opengl");

  // Each texel of a level becomes the mean of the 2 x 2 (x 2) above it: a linear read in their
  // middle. Blits convert sRGB to linear light and back.
  const VkCommandBuffer commands = begin_copies();
  const auto corner = [](const VkExtent3D& extent) {
    return VkOffset3D{static_cast<int>(extent.width), static_cast<int>(extent.height),
                      static_cast<int>(extent.depth)};
  };
  const std::uint32_t layers = texture->all().layer_count;
  for (int level = 1; level < desc.levels; ++level) {
    const auto to = static_cast<std::uint32_t>(level);
    barriers_.add(commands, *texture, {to - 1, 1, 0, layers}, copied_from());
    barriers_.add(commands, *texture, {to, 1, 0, layers}, copied_to(true));
    barriers_.issue(commands);
    const VkImageAspectFlags aspect = aspect_of(desc.format);
    const VkImageBlit2 region{.sType = VK_STRUCTURE_TYPE_IMAGE_BLIT_2,
                              .srcSubresource = {aspect, to - 1, 0, layers},
                              .srcOffsets = {{}, corner(extent_of(desc, level - 1))},
                              .dstSubresource = {aspect, to, 0, layers},
                              .dstOffsets = {{}, corner(extent_of(desc, level))}};
    const VkBlitImageInfo2 blit{.sType = VK_STRUCTURE_TYPE_BLIT_IMAGE_INFO_2,
                                .srcImage = texture->handle,
                                .srcImageLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                .dstImage = texture->handle,
                                .dstImageLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                .regionCount = 1,
                                .pRegions = &region,
                                .filter = VK_FILTER_LINEAR};
    context_.vk().CmdBlitImage2(commands, &blit);
  }
  settle_later(texture);
}

HostBuffer& Transfers::read_back_buffer(std::size_t bytes) {
  if (!read_back_ || read_back_->bytes < bytes) {
    read_back_.reset(); // nothing reads into it: every read-back is waited for
    read_back_ = std::make_unique<HostBuffer>(context_, bytes, MemoryKind::read_back, "read-back");
  }
  return *read_back_;
}

std::vector<std::byte> Transfers::wait_for(const HostBuffer& from, std::size_t bytes) {
  barriers_.add_memory(VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                       VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
  barriers_.issue(commands_.open());
  settle();
  commands_.finish();
  return {from.memory.mapped, from.memory.mapped + bytes};
}

std::vector<std::byte> Transfers::read(GpuBuffer& buffer, std::size_t offset, std::size_t bytes) {
  if (bytes == 0) return {};
  settle(); // uploads to it
  const VkCommandBuffer commands = begin_copies();
  const HostBuffer& to = read_back_buffer(bytes);
  const VkBufferCopy2 region{
      .sType = VK_STRUCTURE_TYPE_BUFFER_COPY_2, .srcOffset = offset, .size = bytes};
  const VkCopyBufferInfo2 copy{.sType = VK_STRUCTURE_TYPE_COPY_BUFFER_INFO_2,
                               .srcBuffer = buffer.handle,
                               .dstBuffer = to.handle,
                               .regionCount = 1,
                               .pRegions = &region};
  context_.vk().CmdCopyBuffer2(commands, &copy);
  return wait_for(to, bytes);
}

std::vector<std::byte> Transfers::read(const std::shared_ptr<GpuTexture>& texture, int level,
                                       int layer) {
  const Range range = range_of(*texture, level, layer);
  const std::size_t bytes = bytes_of(texture->desc, level);
  const VkCommandBuffer commands = begin_copies();
  barriers_.add(commands, *texture, range, copied_from());
  barriers_.issue(commands);
  settle_later(texture);
  const HostBuffer& to = read_back_buffer(bytes);
  const VkBufferImageCopy2 region = whole_layer(*texture, level, layer, 0);
  const VkCopyImageToBufferInfo2 copy{.sType = VK_STRUCTURE_TYPE_COPY_IMAGE_TO_BUFFER_INFO_2,
                                      .srcImage = texture->handle,
                                      .srcImageLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                      .dstBuffer = to.handle,
                                      .regionCount = 1,
                                      .pRegions = &region};
  context_.vk().CmdCopyImageToBuffer2(commands, &copy);
  return wait_for(to, bytes);
}

} // namespace gg::gpu::vulkan
