#include "gpu/checked_encoder.h"

#include "core/error.h"
#include "gpu/checks.h"

namespace gg::gpu {

using shaders::Kind;

void CheckedEncoder::start(const Pass& pass) {
  pass_ = &pass;
  drawing_ = !pass.colors.empty() || pass.depth;
}

void CheckedEncoder::let_go() noexcept {
  for (Bound& bound : bound_)
    bound = {};
  pipeline_.reset();
  pass_ = nullptr;
}

void CheckedEncoder::refuse(const std::string& what) const {
  throw Error(ExitCode::internal,
              "pass '" + pass_->label + "'"
                  + (pipeline_ ? ", pipeline '" + pipeline_->label + "'" : ""),
              what);
}

bool CheckedEncoder::change(const PipelineRef& pipeline) {
  if (!pipeline) refuse("is given no pipeline");
  if (pipeline == pipeline_) return false;
  pipeline_ = std::static_pointer_cast<BuiltPipeline>(pipeline);
  if (drawing_ != pipeline_->drawing.has_value())
    refuse(drawing_ ? "computes, but the pass draws" : "draws, but the pass computes");
  if (drawing_) check_targets(*pipeline_->drawing, *pass_);
  applied_.assign(pipeline_->slots.size(), 0);
  resources_changed_ = true;
  return true;
}

CheckedEncoder::Bound* CheckedEncoder::find(std::string_view name) {
  const int number = names_.find(name);
  if (number < 0) return nullptr;
  if (bound_.size() < names_.size()) bound_.resize(names_.size());
  Bound& bound = bound_[static_cast<std::size_t>(number)];
  bound.version = ++version_;
  resources_changed_ = true;
  return &bound;
}

void CheckedEncoder::buffer(std::string_view block, const BufferRef& buffer, std::size_t offset,
                            std::size_t bytes) {
  Bound* bound = find(block);
  if (!bound) return;
  if (!buffer) refuse(std::string(block) + " is given no buffer");
  const BufferDesc& desc = buffer->desc;
  if (offset % block_alignment != 0)
    refuse(std::string(block) + " starts at byte " + std::to_string(offset) + " of "
           + describe(desc) + ", which is no multiple of " + std::to_string(block_alignment));
  check_range(desc, offset, bytes);
  bound->what = Bound::What::buffer;
  bound->buffer = buffer;
  bound->offset = offset;
  bound->bytes = bytes ? bytes : desc.bytes - offset;
}

void CheckedEncoder::texture(std::string_view name, const View& view, const SamplerRef& sampler) {
  Bound* bound = find(name);
  if (!bound) return;
  check_view(view);
  if (!sampler) refuse(std::string(name) + " is given no sampler");
  bound->what = Bound::What::texture;
  bound->view = view;
  bound->sampler = sampler;
}

void CheckedEncoder::image(std::string_view name, const View& view) {
  Bound* bound = find(name);
  if (!bound) return;
  check_view(view);
  bound->what = Bound::What::image;
  bound->view = view;
}

const CheckedEncoder::Bound& CheckedEncoder::bound_to(const Slot& slot) const {
  const auto number = static_cast<std::size_t>(slot.name);
  const std::string& name = slot.binding.name;
  if (number >= bound_.size() || bound_[number].what == Bound::What::nothing)
    refuse("nothing is bound to " + name);
  const Bound& bound = bound_[number];
  switch (slot.binding.kind) {
  case Kind::uniform_block:
  case Kind::storage_block:
    if (bound.what != Bound::What::buffer) refuse(name + " is bound to no buffer");
    break;
  case Kind::sampled:
    if (bound.what != Bound::What::texture) refuse(name + " is bound to no texture");
    break;
  case Kind::image:
    if (bound.what != Bound::What::image) refuse(name + " is bound to no image");
    break;
  }
  return bound;
}

void CheckedEncoder::check_block(const Slot& slot, const Bound& bound, bool awaited) const {
  const BufferDesc& desc = bound.buffer->desc;
  const bool storage = slot.binding.kind == Kind::storage_block;
  if (!has(desc.use, storage ? Use::storage : Use::uniforms))
    refuse(slot.binding.name + ": " + describe(desc)
           + (storage ? " was not made for storage" : " was not made for uniforms"));
  if (bound.bytes < slot.binding.bytes)
    refuse(slot.binding.name + " takes " + std::to_string(slot.binding.bytes) + " bytes, but "
           + std::to_string(bound.bytes) + " of " + describe(desc) + " are bound");
  if (slot.binding.writes || awaited) check_declared(*pass_, bound.buffer, slot.binding.writes);
}

void CheckedEncoder::check_view_of(const Slot& slot, const Bound& bound) const {
  check_bound(bound.view, slot.binding, pipeline_->label);
  check_declared(*pass_, bound.view, slot.binding.kind == Kind::image);
}

void CheckedEncoder::check_vertices(int binding, const BufferRef& buffer,
                                    std::size_t offset) const {
  if (!buffer) refuse("is given no vertices");
  if (binding < 0) refuse("has no vertex binding " + std::to_string(binding));
  if (!has(buffer->desc.use, Use::vertices))
    refuse(describe(buffer->desc) + " was not made for vertices");
  check_range(buffer->desc, offset, 1);
}

void CheckedEncoder::check_indices(const BufferRef& buffer) const {
  if (!buffer) refuse("is given no indices");
  if (!has(buffer->desc.use, Use::indices))
    refuse(describe(buffer->desc) + " was not made for indices");
}

void CheckedEncoder::check_use(bool draws) const {
  if (!pipeline_) refuse("uses no pipeline");
  if (draws != pipeline_->drawing.has_value())
    refuse(draws ? "draws with a pipeline that computes" : "computes with a pipeline that draws");
}

void CheckedEncoder::check_index_range(const BufferRef& indices, std::uint32_t first,
                                       std::uint32_t count) const {
  if (!indices) refuse("draws with indices but has none");
  check_range(indices->desc, std::size_t{first} * sizeof(std::uint32_t),
              std::size_t{count} * sizeof(std::uint32_t));
}

} // namespace gg::gpu
