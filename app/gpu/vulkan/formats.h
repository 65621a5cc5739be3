// Our formats, uses and comparisons in Vulkan's words.
#pragma once

#include "gpu/types.h"
#include "gpu/vulkan/api.h"

namespace gg::gpu::vulkan {

VkFormat format_of(Format format);
inline VkImageAspectFlags aspect_of(Format format) {
  return format == Format::depth32f ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}
bool is_integer(Format format);

VkImageUsageFlags usage_of(const TextureDesc& desc);
VkBufferUsageFlags usage_of(const BufferDesc& desc);

VkCompareOp compare_of(Compare compare);
VkCullModeFlags cull_of(Cull cull);
VkFilter filter_of(Filter filter);
VkSamplerAddressMode wrap_of(Wrap wrap);
VkPipelineColorBlendAttachmentState blend_of(Blend blend, Format format);
VkFormat attribute_format(int components); // of 1..4 floats; VK_FORMAT_UNDEFINED for others

// Layers of the image that holds a texture: faces for cubes, 1 for a volume.
std::uint32_t layer_count(const TextureDesc& desc);
// Of one level: width, height and, for a volume, depth; at least 1 each.
VkExtent3D extent_of(const TextureDesc& desc, int level);
// The bytes of one level of one layer, face or slice.
std::size_t bytes_of(const TextureDesc& desc, int level);

} // namespace gg::gpu::vulkan
