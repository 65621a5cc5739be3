#include "gpu/vulkan/encoder.h"

#include "gpu/checks.h"
#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/formats.h"

#include <algorithm>
#include <bit>

namespace gg::gpu::vulkan {

namespace {

VkClearColorValue clear_value(Format format, const std::array<float, 4>& value) {
  VkClearColorValue clear{};
  for (std::size_t i = 0; i < value.size(); ++i)
    if (is_integer(format))
      clear.uint32[i] = static_cast<std::uint32_t>(value[i]);
    else
      clear.float32[i] = value[i];
  return clear;
}

} // namespace

void PassEncoder::begin(VkCommandBuffer commands, const Pass& pass) {
  pass_ = &pass;
  buffer_ = commands;
  drawing_ = !pass.colors.empty() || pass.depth;
  if (drawing_) begin_drawing();
}

void PassEncoder::begin_drawing() {
  std::vector<VkRenderingAttachmentInfo> colors;
  for (const ColorTarget& target : pass_->colors) {
    VkRenderingAttachmentInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                   .imageView = of(target.view.texture).attachment(target.view),
                                   .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                   .loadOp = target.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR
                                                          : VK_ATTACHMENT_LOAD_OP_LOAD,
                                   .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    if (target.clear)
      info.clearValue.color = clear_value(target.view.texture->desc.format, *target.clear);
    colors.push_back(info);
  }
  VkRenderingAttachmentInfo depth{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  if (pass_->depth) {
    const DepthTarget& target = *pass_->depth;
    depth.imageView = of(target.view.texture).attachment(target.view);
    depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    depth.loadOp = target.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    depth.clearValue.depthStencil.depth = target.clear.value_or(0.0f);
  }
  const Extent size = target_extent(*pass_);
  const VkRect2D area{
      .extent = {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)}};
  const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                             .renderArea = area,
                             .layerCount = 1,
                             .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                             .pColorAttachments = colors.data(),
                             .pDepthAttachment = pass_->depth ? &depth : nullptr};
  vk_.CmdBeginRendering(buffer_, &info);

  // Upside down, so that y points up in clip space and row 0 is still the top.
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  const VkViewport viewport{0.0f, height, width, -height, 0.0f, 1.0f};
  vk_.CmdSetViewport(buffer_, 0, 1, &viewport);
  vk_.CmdSetScissor(buffer_, 0, 1, &area);
  vk_.CmdSetFrontFace(buffer_, VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

void PassEncoder::end() {
  if (drawing_) vk_.CmdEndRendering(buffer_);
  for (Bound& bound : bound_)
    bound = {};
  vertices_.clear();
  indices_.reset();
  pipeline_.reset();
  set_layout_ = nullptr;
  pass_ = nullptr;
}

void PassEncoder::refuse(const std::string& what) const {
  throw Error(ExitCode::internal,
              "pass '" + pass_->label + "'"
                  + (pipeline_ ? ", pipeline '" + pipeline_->label + "'" : ""),
              what);
}

void PassEncoder::use(const PipelineRef& pipeline) {
  if (!pipeline) refuse("is given no pipeline");
  if (pipeline != pipeline_) {
    pipeline_ = std::static_pointer_cast<GpuPipeline>(pipeline);
    if (drawing_ != pipeline_->drawing.has_value())
      refuse(drawing_ ? "computes, but the pass draws" : "draws, but the pass computes");
    if (drawing_) check_targets(*pipeline_->drawing, *pass_);
    vk_.CmdBindPipeline(buffer_,
                        drawing_ ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE,
                        pipeline_->handle);
    applied_.assign(pipeline_->slots.size(), 0);
    resources_changed_ = true;
  }
  if (drawing_) cull(pipeline_->drawing->cull);
}

PassEncoder::Bound* PassEncoder::find(std::string_view name) {
  const int number = names_.find(name);
  if (number < 0) return nullptr;
  if (bound_.size() < names_.size()) bound_.resize(names_.size());
  Bound& bound = bound_[static_cast<std::size_t>(number)];
  bound.version = ++version_;
  resources_changed_ = true;
  return &bound;
}

void PassEncoder::buffer(std::string_view block, const BufferRef& buffer, std::size_t offset,
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

void PassEncoder::texture(std::string_view name, const View& view, const SamplerRef& sampler) {
  Bound* bound = find(name);
  if (!bound) return;
  check_view(view);
  if (!sampler) refuse(std::string(name) + " is given no sampler");
  bound->what = Bound::What::texture;
  bound->view = view;
  bound->sampler = sampler;
}

void PassEncoder::image(std::string_view name, const View& view) {
  Bound* bound = find(name);
  if (!bound) return;
  check_view(view);
  bound->what = Bound::What::image;
  bound->view = view;
}

void PassEncoder::vertices(int binding, const BufferRef& buffer, std::size_t offset) {
  if (!buffer) refuse("is given no vertices");
  if (binding < 0) refuse("has no vertex binding " + std::to_string(binding));
  check_range(buffer->desc, offset, 1);
  GpuBuffer& given = of(buffer);
  if (!is_ready(given, buffer_read(true))) check_declared(*pass_, buffer, false);
  const auto index = static_cast<std::size_t>(binding);
  if (vertices_.size() <= index) vertices_.resize(index + 1);
  vertices_[index] = buffer;
  const VkDeviceSize start = offset;
  vk_.CmdBindVertexBuffers(buffer_, static_cast<std::uint32_t>(binding), 1, &given.handle, &start);
}

void PassEncoder::indices(const BufferRef& buffer) {
  if (!buffer) refuse("is given no indices");
  GpuBuffer& given = of(buffer);
  if (!is_ready(given, buffer_read(true))) check_declared(*pass_, buffer, false);
  indices_ = buffer;
  vk_.CmdBindIndexBuffer(buffer_, given.handle, 0, VK_INDEX_TYPE_UINT32);
}

void PassEncoder::cull(Cull cull) {
  vk_.CmdSetCullMode(buffer_, cull_of(cull));
}

void PassEncoder::front_is_clockwise(bool clockwise) {
  vk_.CmdSetFrontFace(buffer_,
                      clockwise ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

void PassEncoder::draw(std::uint32_t vertex_count, std::uint32_t instance_count) {
  prepare(true);
  vk_.CmdDraw(buffer_, vertex_count, instance_count, 0, 0);
  ++context_.counters.draws;
}

void PassEncoder::draw_indexed(std::uint32_t index_count, std::uint32_t instance_count,
                               std::uint32_t first_index) {
  prepare(true);
  if (!indices_) refuse("draws with indices but has none");
  check_range(indices_->desc, std::size_t{first_index} * sizeof(std::uint32_t),
              std::size_t{index_count} * sizeof(std::uint32_t));
  vk_.CmdDrawIndexed(buffer_, index_count, instance_count, first_index, 0, 0);
  ++context_.counters.draws;
}

void PassEncoder::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  prepare(false);
  check_dispatch(x, y, z, limits_, pipeline_->label);
  vk_.CmdDispatch(buffer_, x, y, z);
  ++context_.counters.dispatches;
}

void PassEncoder::prepare(bool draws) {
  if (!pipeline_) refuse("uses no pipeline");
  if (draws != pipeline_->drawing.has_value())
    refuse(draws ? "draws with a pipeline that computes" : "computes with a pipeline that draws");
  if (resources_changed_) bind_resources();
  resources_changed_ = false;
  if (draws) check_vertices();
}

void PassEncoder::check_vertices() const {
  for (std::size_t i = 0; i < pipeline_->drawing->bindings.size(); ++i)
    if (i >= vertices_.size() || !vertices_[i])
      refuse("nothing is bound to vertex binding " + std::to_string(i));
}

} // namespace gg::gpu::vulkan
