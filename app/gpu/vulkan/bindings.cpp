// The part of PassEncoder that gives a pipeline's resources to Vulkan.
#include "gpu/checks.h"
#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/encoder.h"

namespace gg::gpu::vulkan {

using shaders::Kind;

void PassEncoder::bind_resources() {
  previous_offsets_.swap(offsets_);
  const bool other_contents = describe_all();
  if (set_layout_ != pipeline().layout || other_contents)
    find_set();
  else if (offsets_ == previous_offsets_)
    return;
  if (pipeline().slots.empty()) return;
  vk_.CmdBindDescriptorSets(
      buffer_, drawing() ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE,
      pipeline().layout->pipeline, 0, 1, &set_, static_cast<std::uint32_t>(offsets_.size()),
      offsets_.data());
}

bool PassEncoder::describe_all() {
  const std::vector<Slot>& slots = pipeline().slots;
  bool changed = descriptors_.size() != slots.size();
  descriptors_.resize(slots.size());
  offsets_.clear();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Slot& slot = slots[i];
    const Bound& bound = bound_to(slot);
    if (slot.binding.kind == Kind::uniform_block)
      offsets_.push_back(static_cast<std::uint32_t>(bound.offset));
    if (applied_[i] == bound.version) continue;
    const Descriptor wanted = describe_one(slot, bound);
    applied_[i] = bound.version;
    if (wanted.identity == descriptors_[i].identity) continue;
    descriptors_[i] = wanted;
    changed = true;
  }
  return changed;
}

PassEncoder::Descriptor PassEncoder::describe_one(const Slot& slot, const Bound& bound) {
  switch (slot.binding.kind) {
  case Kind::uniform_block:
  case Kind::storage_block:
    return describe_buffer(slot, bound);
  case Kind::sampled:
    return describe_texture(slot, bound);
  case Kind::image:
    return describe_image(slot, bound);
  }
  return {};
}

PassEncoder::Descriptor PassEncoder::describe_buffer(const Slot& slot, const Bound& bound) {
  GpuBuffer& buffer = of(bound.buffer);
  check_block(slot, bound, !is_ready(buffer, buffer_read(drawing())));
  const bool storage = slot.binding.kind == Kind::storage_block;
  // The offset of a uniform block is given when the set is bound.
  const VkDeviceSize offset = storage ? bound.offset : 0;
  const VkDeviceSize range = storage ? bound.bytes : slot.binding.bytes;
  return {.buffer = {buffer.handle, offset, range}, .identity = {buffer.serial, offset, range}};
}

PassEncoder::Descriptor PassEncoder::describe_texture(const Slot& slot, const Bound& bound) {
  check_view_of(slot, bound);
  GpuTexture& texture = of(bound.view.texture);
  const GpuSampler& sampler = of(bound.sampler);
  const Range range = texture.range_of(bound.view);
  const GpuTexture::Seen seen = texture.view(bound.view, slot.binding.shape);
  const VkImageLayout layout = texture.state(range.level, range.layer).layout;
  return {.image = {sampler.handle, seen.handle, layout},
          .identity = {seen.serial, sampler.serial, static_cast<std::uint64_t>(layout)}};
}

PassEncoder::Descriptor PassEncoder::describe_image(const Slot& slot, const Bound& bound) {
  check_view_of(slot, bound);
  const GpuTexture::Seen seen = of(bound.view.texture).view(bound.view, slot.binding.shape);
  return {.image = {VK_NULL_HANDLE, seen.handle, VK_IMAGE_LAYOUT_GENERAL},
          .identity = {seen.serial, 0, VK_IMAGE_LAYOUT_GENERAL}};
}

void PassEncoder::find_set() {
  contents_.clear();
  for (const Descriptor& descriptor : descriptors_)
    contents_.insert(contents_.end(), descriptor.identity.begin(), descriptor.identity.end());
  const SetCache::Found found = sets_.find(*pipeline().layout, contents_);
  set_ = found.set;
  set_layout_ = pipeline().layout;
  if (found.holds_it) return;

  writes_.clear();
  for (std::size_t i = 0; i < descriptors_.size(); ++i)
    writes_.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                       .dstSet = set_,
                       .dstBinding = pipeline().slots[i].binding.binding,
                       .descriptorCount = 1,
                       .descriptorType = descriptor_type(pipeline().slots[i].binding.kind),
                       .pImageInfo = &descriptors_[i].image,
                       .pBufferInfo = &descriptors_[i].buffer});
  vk_.UpdateDescriptorSets(context_.device(), static_cast<std::uint32_t>(writes_.size()),
                           writes_.data(), 0, nullptr);
}

} // namespace gg::gpu::vulkan
