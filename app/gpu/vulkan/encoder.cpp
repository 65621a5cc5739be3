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
  start(pass);
  buffer_ = commands;
  if (drawing()) begin_drawing();
}

void PassEncoder::begin_drawing() {
  std::vector<VkRenderingAttachmentInfo> colors;
  for (const ColorTarget& target : pass().colors) {
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
  if (pass().depth) {
    const DepthTarget& target = *pass().depth;
    depth.imageView = of(target.view.texture).attachment(target.view);
    depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    depth.loadOp = target.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    depth.clearValue.depthStencil.depth = target.clear.value_or(0.0f);
  }
  const Extent size = target_extent(pass());
  const VkRect2D area{
      .extent = {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)}};
  const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                             .renderArea = area,
                             .layerCount = 1,
                             .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                             .pColorAttachments = colors.data(),
                             .pDepthAttachment = pass().depth ? &depth : nullptr};
  vk_.CmdBeginRendering(buffer_, &info);

  // Upside down, so that y points up in clip space and row 0 is still the top.
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  const VkViewport viewport{0.0f, height, width, -height, 0.0f, 1.0f};
  vk_.CmdSetViewport(buffer_, 0, 1, &viewport);
  vk_.CmdSetScissor(buffer_, 0, 1, &area);
  vk_.CmdSetFrontFace(buffer_, VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

void PassEncoder::end() {
  if (drawing()) vk_.CmdEndRendering(buffer_);
  vertices_.clear();
  indices_.reset();
  set_layout_ = nullptr;
  let_go();
}

void PassEncoder::use(const PipelineRef& given) {
  if (change(given))
    vk_.CmdBindPipeline(
        buffer_, drawing() ? VK_PIPELINE_BIND_POINT_GRAPHICS : VK_PIPELINE_BIND_POINT_COMPUTE,
        pipeline().handle);
  if (drawing()) cull(pipeline().drawing->cull);
}

void PassEncoder::vertices(int binding, const BufferRef& buffer, std::size_t offset) {
  check_vertices(binding, buffer, offset);
  GpuBuffer& given = of(buffer);
  if (!is_ready(given, buffer_read(true))) check_declared(pass(), buffer, false);
  const auto index = static_cast<std::size_t>(binding);
  if (vertices_.size() <= index) vertices_.resize(index + 1);
  vertices_[index] = buffer;
  const VkDeviceSize start = offset;
  vk_.CmdBindVertexBuffers(buffer_, static_cast<std::uint32_t>(binding), 1, &given.handle, &start);
}

void PassEncoder::indices(const BufferRef& buffer) {
  check_indices(buffer);
  GpuBuffer& given = of(buffer);
  if (!is_ready(given, buffer_read(true))) check_declared(pass(), buffer, false);
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
  check_index_range(indices_, first_index, index_count);
  vk_.CmdDrawIndexed(buffer_, index_count, instance_count, first_index, 0, 0);
  ++context_.counters.draws;
}

void PassEncoder::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  prepare(false);
  check_dispatch(x, y, z, limits_, pipeline().label);
  vk_.CmdDispatch(buffer_, x, y, z);
  ++context_.counters.dispatches;
}

void PassEncoder::prepare(bool draws) {
  check_use(draws);
  if (resources_changed_) bind_resources();
  resources_changed_ = false;
  if (draws) check_vertices_are_bound();
}

void PassEncoder::check_vertices_are_bound() const {
  for (std::size_t i = 0; i < pipeline().drawing->bindings.size(); ++i)
    if (i >= vertices_.size() || !vertices_[i])
      refuse("nothing is bound to vertex binding " + std::to_string(i));
}

} // namespace gg::gpu::vulkan
