#include "gpu/vulkan/formats.h"

namespace gg::gpu::vulkan {

VkFormat format_of(Format format) {
  switch (format) {
  case Format::none:
    return VK_FORMAT_UNDEFINED;
  case Format::r8:
    return VK_FORMAT_R8_UNORM;
  case Format::rg8:
    return VK_FORMAT_R8G8_UNORM;
  case Format::rgba8:
    return VK_FORMAT_R8G8B8A8_UNORM;
  case Format::rgba8_srgb:
    return VK_FORMAT_R8G8B8A8_SRGB;
  case Format::r16f:
    return VK_FORMAT_R16_SFLOAT;
  case Format::rg16f:
    return VK_FORMAT_R16G16_SFLOAT;
  case Format::rgba16f:
    return VK_FORMAT_R16G16B16A16_SFLOAT;
  case Format::r32f:
    return VK_FORMAT_R32_SFLOAT;
  case Format::rg32f:
    return VK_FORMAT_R32G32_SFLOAT;
  case Format::rgba32f:
    return VK_FORMAT_R32G32B32A32_SFLOAT;
  case Format::r32ui:
    return VK_FORMAT_R32_UINT;
  case Format::rg32ui:
    return VK_FORMAT_R32G32_UINT;
  case Format::rgba32ui:
    return VK_FORMAT_R32G32B32A32_UINT;
  case Format::depth32f:
    return VK_FORMAT_D32_SFLOAT;
  }
  return VK_FORMAT_UNDEFINED;
}

bool is_integer(Format format) {
  return format == Format::r32ui || format == Format::rg32ui || format == Format::rgba32ui;
}

VkImageUsageFlags usage_of(const TextureDesc& desc) {
  // Everything can be uploaded, cleared, reduced and read back.
  VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (has(desc.use, Use::sampled)) usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
  if (has(desc.use, Use::storage)) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  if (has(desc.use, Use::attachment))
    usage |= desc.format == Format::depth32f ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                             : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  return usage;
}

VkBufferUsageFlags usage_of(const BufferDesc& desc) {
  VkBufferUsageFlags usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (has(desc.use, Use::vertices)) usage |= VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
  if (has(desc.use, Use::indices)) usage |= VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
  if (has(desc.use, Use::uniforms)) usage |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
  if (has(desc.use, Use::storage)) usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  return usage;
}

VkCompareOp compare_of(Compare compare) {
  switch (compare) {
  case Compare::never:
    return VK_COMPARE_OP_NEVER;
  case Compare::less:
    return VK_COMPARE_OP_LESS;
  case Compare::equal:
    return VK_COMPARE_OP_EQUAL;
  case Compare::less_equal:
    return VK_COMPARE_OP_LESS_OR_EQUAL;
  case Compare::greater:
    return VK_COMPARE_OP_GREATER;
  case Compare::greater_equal:
    return VK_COMPARE_OP_GREATER_OR_EQUAL;
  case Compare::always:
    return VK_COMPARE_OP_ALWAYS;
  }
  return VK_COMPARE_OP_ALWAYS;
}

VkCullModeFlags cull_of(Cull cull) {
  switch (cull) {
  case Cull::none:
    return VK_CULL_MODE_NONE;
  case Cull::back:
    return VK_CULL_MODE_BACK_BIT;
  case Cull::front:
    return VK_CULL_MODE_FRONT_BIT;
  }
  return VK_CULL_MODE_NONE;
}

VkFilter filter_of(Filter filter) {
  return filter == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
}

VkSamplerAddressMode wrap_of(Wrap wrap) {
  switch (wrap) {
  case Wrap::repeat:
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
  case Wrap::mirrored_repeat:
    return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
  case Wrap::clamp:
    return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  }
  return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

VkPipelineColorBlendAttachmentState blend_of(Blend blend, Format format) {
  VkPipelineColorBlendAttachmentState state{
      .srcColorBlendFactor = VK_BLEND_FACTOR_ONE,
      .dstColorBlendFactor = VK_BLEND_FACTOR_ZERO,
      .colorBlendOp = VK_BLEND_OP_ADD,
      .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
      .dstAlphaBlendFactor = VK_BLEND_FACTOR_ZERO,
      .alphaBlendOp = VK_BLEND_OP_ADD,
      .colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT
                        | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
  if (blend == Blend::none || is_integer(format)) return state; // integers are never blended
  state.blendEnable = VK_TRUE;
  state.dstColorBlendFactor = state.dstAlphaBlendFactor =
      blend == Blend::over ? VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
  return state;
}

VkFormat attribute_format(int components) {
  switch (components) {
  case 1:
    return VK_FORMAT_R32_SFLOAT;
  case 2:
    return VK_FORMAT_R32G32_SFLOAT;
  case 3:
    return VK_FORMAT_R32G32B32_SFLOAT;
  case 4:
    return VK_FORMAT_R32G32B32A32_SFLOAT;
  default:
    return VK_FORMAT_UNDEFINED;
  }
}

std::uint32_t layer_count(const TextureDesc& desc) {
  return desc.shape == Shape::d3 ? 1 : static_cast<std::uint32_t>(extent(desc, 0).layers);
}

VkExtent3D extent_of(const TextureDesc& desc, int level) {
  const Extent size = extent(desc, level);
  return {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height),
          desc.shape == Shape::d3 ? static_cast<std::uint32_t>(size.layers) : 1};
}

std::size_t bytes_of(const TextureDesc& desc, int level) {
  const VkExtent3D size = extent_of(desc, level);
  return std::size_t{size.width} * size.height * bytes_per_texel(desc.format);
}

} // namespace gg::gpu::vulkan
