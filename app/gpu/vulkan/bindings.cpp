// The part of PassEncoder that gives a pipeline's resources to Vulkan.
#include "gpu/checks.h"
#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/encoder.h"

namespace gg::gpu::vulkan {

using shaders::Kind;

bool PassEncoder::Descriptor::operator==(const Descriptor& other) const {
  return buffer.buffer == other.buffer.buffer && buffer.offset == other.buffer.offset
         && buffer.range == other.buffer.range && image.imageView == other.image.imageView
         && image.sampler == other.image.sampler && image.imageLayout == other.image.imageLayout;
}

void PassEncoder::bind_resources() {
  const std::vector<Slot>& slots = pipeline_->slots;
  const bool other_layout = set_layout_ != pipeline_->layout;
  previous_offsets_.swap(offsets_);
  const bool other_contents = describe_all();
  if (other_layout || other_contents) {
    set_ = commands_.descriptor_set(*pipeline_->layout);
    set_layout_ = pipeline_->layout;
    write_set();
  } else if (offsets_ == previous_offsets_) {
    return;
  }
  if (slots.empty()) return;
  vk_.CmdBindDescriptorSets(
      buffer_, drawing_ ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE,
      pipeline_->layout->pipeline, 0, 1, &set_, static_cast<std::uint32_t>(offsets_.size()),
      offsets_.data());
}

bool PassEncoder::describe_all() {
  const std::vector<Slot>& slots = pipeline_->slots;
  bool changed = descriptors_.size() != slots.size();
  descriptors_.resize(slots.size());
  offsets_.clear();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Slot& slot = slots[i];
    const auto number = static_cast<std::size_t>(slot.name);
    if (number >= bound_.size() || bound_[number].what == Bound::What::nothing)
      refuse("nothing is bound to " + slot.binding.name);
    const Bound& bound = bound_[number];
    if (slot.binding.kind == Kind::uniform_block)
      offsets_.push_back(static_cast<std::uint32_t>(bound.offset));
    if (applied_[i] == bound.version) continue;
    const Descriptor wanted = describe_one(slot, bound);
    applied_[i] = bound.version;
    if (wanted == descriptors_[i]) continue;
    descriptors_[i] = wanted;
    changed = true;
  }
  return changed;
}

void PassEncoder::check_buffer(const Slot& slot, const Bound& bound) const {
  const std::string& name = slot.binding.name;
  if (bound.what != Bound::What::buffer) refuse(name + " is bound to no buffer");
  GpuBuffer& buffer = of(bound.buffer);
  const bool storage = slot.binding.kind == Kind::storage_block;
  if (!has(buffer.desc.use, storage ? Use::storage : Use::uniforms))
    refuse(name + ": " + describe(buffer.desc)
           + (storage ? " was not made for storage" : " was not made for uniforms"));
  if (bound.bytes < slot.binding.bytes)
    refuse(name + " takes " + std::to_string(slot.binding.bytes) + " bytes, but "
           + std::to_string(bound.bytes) + " of " + describe(buffer.desc) + " are bound");
  if (slot.binding.writes || !is_ready(buffer, buffer_read(drawing_)))
    check_declared(*pass_, bound.buffer, slot.binding.writes);
}

PassEncoder::Descriptor PassEncoder::describe_one(const Slot& slot, const Bound& bound) {
  switch (slot.binding.kind) {
  case Kind::uniform_block: // its offset is given when the set is bound
    check_buffer(slot, bound);
    return {.buffer = {of(bound.buffer).handle, 0, slot.binding.bytes}};
  case Kind::storage_block:
    check_buffer(slot, bound);
    return {.buffer = {of(bound.buffer).handle, bound.offset, bound.bytes}};
  case Kind::sampled: {
    if (bound.what != Bound::What::texture) refuse(slot.binding.name + " is bound to no texture");
    check_bound(bound.view, slot.binding, pipeline_->label);
    check_declared(*pass_, bound.view, false);
    GpuTexture& texture = of(bound.view.texture);
    const Range range = texture.range_of(bound.view);
    return {.image = {of(bound.sampler).handle, texture.view(bound.view, slot.binding.shape),
                      texture.state(range.level, range.layer).layout}};
  }
  case Kind::image:
    if (bound.what != Bound::What::image) refuse(slot.binding.name + " is bound to no image");
    check_bound(bound.view, slot.binding, pipeline_->label);
    check_declared(*pass_, bound.view, true);
    return {.image = {VK_NULL_HANDLE, of(bound.view.texture).view(bound.view, slot.binding.shape),
                      VK_IMAGE_LAYOUT_GENERAL}};
  }
  return {};
}

void PassEncoder::write_set() {
  writes_.clear();
  for (std::size_t i = 0; i < descriptors_.size(); ++i)
    writes_.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                       .dstSet = set_,
                       .dstBinding = pipeline_->slots[i].binding.binding,
                       .descriptorCount = 1,
                       .descriptorType = descriptor_type(pipeline_->slots[i].binding.kind),
                       .pImageInfo = &descriptors_[i].image,
                       .pBufferInfo = &descriptors_[i].buffer});
  vk_.UpdateDescriptorSets(context_.device(), static_cast<std::uint32_t>(writes_.size()),
                           writes_.data(), 0, nullptr);
}

} // namespace gg::gpu::vulkan
