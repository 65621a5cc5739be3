#include "gpu/vulkan/resources.h"

#include "gpu/checks.h"
#include "gpu/vulkan/formats.h"

#include <fmt/format.h>

#include <algorithm>

namespace gg::gpu::vulkan {

namespace {

// Throws Error(device) if the device cannot have such an image.
void check_support(const Context& context, const VkImageCreateInfo& info, const TextureDesc& desc) {
  const VkPhysicalDeviceImageFormatInfo2 wanted{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_IMAGE_FORMAT_INFO_2,
      .format = info.format,
      .type = info.imageType,
      .tiling = info.tiling,
      .usage = info.usage,
      .flags = info.flags};
  VkImageFormatProperties2 has{.sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_PROPERTIES_2};
  const VkResult result = context.instance().functions().GetPhysicalDeviceImageFormatProperties2(
      context.adapter().handle, &wanted, &has);
  if (result == VK_ERROR_FORMAT_NOT_SUPPORTED)
    throw Error(ExitCode::device, "vulkan",
                fmt::format("the {} has a format (VkFormat {}) that the device cannot use so",
                            describe(desc), static_cast<int>(info.format)),
                "Choose another --device or --backend opengl");
  check(result, "asking for the limits of textures");
  if (bytes(desc) > has.imageFormatProperties.maxResourceSize)
    throw error_of(VK_ERROR_OUT_OF_DEVICE_MEMORY, "creating the " + describe(desc));
}

} // namespace

GpuBuffer::GpuBuffer(std::shared_ptr<Context> owner, const BufferDesc& what)
    : context(std::move(owner)) {
  desc = what;
  const std::string doing = "creating the " + describe(desc);
  const std::uint64_t limit = context->adapter().abilities.max_buffer;
  if (limit != 0 && desc.bytes > limit) throw error_of(VK_ERROR_OUT_OF_DEVICE_MEMORY, doing);

  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                .size = desc.bytes,
                                .usage = usage_of(desc),
                                .sharingMode = VK_SHARING_MODE_EXCLUSIVE};
  const DeviceFunctions& vk = context->vk();
  if (const auto result = vk.CreateBuffer(context->device(), &info, nullptr, &handle))
    throw error_of(result, doing);
  try {
    memory = context->bind_memory(handle, MemoryKind::device, doing);
    context->name(VK_OBJECT_TYPE_BUFFER, handle, desc.label);
  } catch (...) {
    vk.DestroyBuffer(context->device(), handle, nullptr);
    throw;
  }
  serial = context->next_serial();
  ++context->counters.created;
  context->held_bytes += memory.bytes;
}

GpuBuffer::~GpuBuffer() {
  context->held_bytes -= memory.bytes;
  context->retire([&shared = *context, buffer = handle, piece = memory] {
    shared.vk().DestroyBuffer(shared.device(), buffer, nullptr);
    shared.memory().give(piece);
  });
}

GpuTexture::GpuTexture(std::shared_ptr<Context> owner, const TextureDesc& what)
    : context(std::move(owner)) {
  desc = what;
  layers_ = layer_count(desc);
  VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                         .imageType = desc.shape == Shape::d3 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
                         .format = format_of(desc.format),
                         .extent = extent_of(desc, 0),
                         .mipLevels = static_cast<std::uint32_t>(desc.levels),
                         .arrayLayers = layers_,
                         .samples = VK_SAMPLE_COUNT_1_BIT,
                         .tiling = VK_IMAGE_TILING_OPTIMAL,
                         .usage = usage_of(desc),
                         .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
                         .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
  if (desc.shape == Shape::cube || desc.shape == Shape::cube_array)
    info.flags |= VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
  if (desc.shape == Shape::d3 && has(desc.use, Use::attachment))
    info.flags |= VK_IMAGE_CREATE_2D_ARRAY_COMPATIBLE_BIT; // slices are drawn into
  check_support(*context, info, desc);
  if (desc.shape == Shape::cube_array && !context->features().imageCubeArray)
    throw Error(ExitCode::device, "vulkan",
                "the " + describe(desc) + ": the device has no arrays of cubes",
                "Choose another --device or --backend opengl");
  const std::string doing = "creating the " + describe(desc) + ", " + in_words(bytes(desc));
  const DeviceFunctions& vk = context->vk();
  if (const auto result = vk.CreateImage(context->device(), &info, nullptr, &handle))
    throw error_of(result, doing);
  try {
    memory = context->bind_memory(handle, doing);
    context->name(VK_OBJECT_TYPE_IMAGE, handle, desc.label);
  } catch (...) {
    vk.DestroyImage(context->device(), handle, nullptr);
    throw;
  }
  states_.resize(std::size_t{layers_} * static_cast<std::size_t>(desc.levels));
  ++context->counters.created;
  context->held_bytes += memory.bytes;
}

GpuTexture::~GpuTexture() {
  context->held_bytes -= memory.bytes;
  context->retire([&shared = *context, image = handle, piece = memory, views = std::move(views_)] {
    for (const CachedView& view : views)
      shared.vk().DestroyImageView(shared.device(), view.seen.handle, nullptr);
    shared.vk().DestroyImage(shared.device(), image, nullptr);
    shared.memory().give(piece);
  });
}

Range GpuTexture::range_of(const View& view) const {
  check_view(view);
  Range range{static_cast<std::uint32_t>(view.level), static_cast<std::uint32_t>(view.level_count),
              static_cast<std::uint32_t>(view.layer), static_cast<std::uint32_t>(view.layer_count)};
  if (desc.shape == Shape::d3) range.layer = 0, range.layer_count = 1;
  return range;
}

GpuTexture::Seen GpuTexture::view(const View& view, Shape shape) {
  if (desc.shape == Shape::d3 && shape != Shape::d3)
    throw Error(ExitCode::internal, "vulkan",
                "the " + describe(desc)
                    + " is bound by slices, which Vulkan cannot do: bind it "
                      "whole, as a volume");
  constexpr VkImageViewType types[]{VK_IMAGE_VIEW_TYPE_2D, VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                                    VK_IMAGE_VIEW_TYPE_3D, VK_IMAGE_VIEW_TYPE_CUBE,
                                    VK_IMAGE_VIEW_TYPE_CUBE_ARRAY};
  return find_or_make(types[static_cast<int>(shape)], range_of(view));
}

VkImageView GpuTexture::attachment(const View& view) {
  Range range = range_of(view);
  range.layer = static_cast<std::uint32_t>(view.layer); // a slice of a volume is drawn into as one
  return find_or_make(VK_IMAGE_VIEW_TYPE_2D, range).handle;
}

GpuTexture::Seen GpuTexture::find_or_make(VkImageViewType type, const Range& range) {
  for (const CachedView& cached : views_)
    if (cached.type == type && cached.range.level == range.level
        && cached.range.level_count == range.level_count && cached.range.layer == range.layer
        && cached.range.layer_count == range.layer_count)
      return cached.seen;

  const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                   .image = handle,
                                   .viewType = type,
                                   .format = format_of(desc.format),
                                   .subresourceRange = {aspect_of(desc.format), range.level,
                                                        range.level_count, range.layer,
                                                        range.layer_count}};
  VkImageView made = VK_NULL_HANDLE;
  check(context->vk().CreateImageView(context->device(), &info, nullptr, &made),
        ("viewing the " + describe(desc)).c_str());
  views_.push_back({type, range, {made, context->next_serial()}});
  ++context->counters.created;
  context->name(VK_OBJECT_TYPE_IMAGE_VIEW, made, desc.label);
  return views_.back().seen;
}

GpuSampler::GpuSampler(std::shared_ptr<Context> owner, const SamplerDesc& what)
    : context(std::move(owner)) {
  desc = what;
  const float anisotropy = std::min(desc.max_anisotropy, context->limits().maxSamplerAnisotropy);
  const bool anisotropic = context->features().samplerAnisotropy && anisotropy > 1.0f;
  // Vulkan minifies above level 0 only: a quarter keeps that apart from magnifying, and rounds to
  // level 0 (the specification's way to have OpenGL's filters without levels).
  const bool one_level = desc.max_level <= 0.0f;
  const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                 .magFilter = filter_of(desc.magnify),
                                 .minFilter = filter_of(desc.minify),
                                 .mipmapMode = desc.between_levels == Filter::linear && !one_level
                                                   ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                   : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                 .addressModeU = wrap_of(desc.u),
                                 .addressModeV = wrap_of(desc.v),
                                 .addressModeW = wrap_of(desc.w),
                                 .anisotropyEnable = anisotropic,
                                 .maxAnisotropy = anisotropic ? anisotropy : 1.0f,
                                 .maxLod = one_level ? 0.25f : desc.max_level};
  check(context->vk().CreateSampler(context->device(), &info, nullptr, &handle),
        "creating a sampler");
  context->name(VK_OBJECT_TYPE_SAMPLER, handle, describe(desc));
  serial = context->next_serial();
  ++context->counters.created;
}

GpuSampler::~GpuSampler() {
  context->retire([&shared = *context, sampler = handle] {
    shared.vk().DestroySampler(shared.device(), sampler, nullptr);
  });
}

} // namespace gg::gpu::vulkan
