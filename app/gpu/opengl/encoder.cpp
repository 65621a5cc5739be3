#include "gpu/opengl/encoder.h"

#include "core/error.h"
#include "gpu/opengl/formats.h"

#include <algorithm>

namespace gg::gpu::opengl {
namespace {

bool holds_integers(Format format) {
  return format == Format::r32ui || format == Format::rg32ui || format == Format::rgba32ui;
}

void clear_color(const GladGLContext& gl, GLuint framebuffer, GLint index, Format format,
                 const std::array<float, 4>& value) {
  if (holds_integers(format)) {
    std::array<GLuint, 4> integers{};
    std::ranges::transform(value, integers.begin(), [](float v) { return static_cast<GLuint>(v); });
    gl.ClearNamedFramebufferuiv(framebuffer, GL_COLOR, index, integers.data());
  } else {
    gl.ClearNamedFramebufferfv(framebuffer, GL_COLOR, index, value.data());
  }
}

} // namespace

void GlEncoder::begin(const Pass& pass) {
  start(pass);
  context_->gl();
  const auto make_visible = [&](const View& view) {
    context_->make_visible(of(view.texture, pass.label).written);
  };
  std::ranges::for_each(pass.reads, make_visible);
  std::ranges::for_each(pass.storage, make_visible);
  for (const ColorTarget& target : pass.colors)
    make_visible(target.view);
  if (pass.depth) make_visible(pass.depth->view);
  for (const auto* buffers : {&pass.reads_buffers, &pass.writes_buffers})
    for (const BufferRef& buffer : *buffers)
      context_->make_visible(of(buffer, pass.label).written);
  if (drawing()) bind_targets();
}

void GlEncoder::bind_targets() {
  colors_.clear();
  for (const ColorTarget& target : pass().colors)
    colors_.push_back(of(target.view.texture, pass().label).attachment(target.view));
  Attachment depth;
  if (pass().depth)
    depth = of(pass().depth->view.texture, pass().label).attachment(pass().depth->view);
  const GLuint framebuffer =
      context_->framebuffers.find_or_make(*context_, colors_, depth, pass().label);

  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  const Extent size = target_extent(pass());
  gl_.Viewport(0, 0, size.width, size.height);
  gl_.FrontFace(GL_CCW);
  gl_.DepthMask(GL_TRUE); // clears obey it
  for (std::size_t i = 0; i < pass().colors.size(); ++i)
    if (const auto& clear = pass().colors[i].clear)
      clear_color(gl_, framebuffer, static_cast<GLint>(i),
                  pass().colors[i].view.texture->desc.format, *clear);
  if (pass().depth && pass().depth->clear)
    gl_.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &*pass().depth->clear);
}

void GlEncoder::end() noexcept {
  if (!pass().storage.empty() || !pass().writes_buffers.empty()) ++context_->writes;
  for (const View& view : pass().storage)
    static_cast<GlTexture&>(*view.texture).written = context_->writes;
  for (const BufferRef& buffer : pass().writes_buffers)
    static_cast<GlBuffer&>(*buffer).written = context_->writes;
  detach_vertices();
  vertices_.clear();
  indices_.reset();
  let_go();
}

// A vertex array would keep the memory of its buffers alive after their owners are gone.
void GlEncoder::detach_vertices() noexcept {
  for (const auto& pipeline : used_) {
    const auto count = static_cast<GLsizei>(pipeline->drawing->bindings.size());
    gl_.VertexArrayVertexBuffers(pipeline->vertex_array, 0, count, nullptr, nullptr, nullptr);
    gl_.VertexArrayElementBuffer(pipeline->vertex_array, 0);
  }
  used_.clear();
}

void GlEncoder::use(const PipelineRef& given) {
  if (!change(given)) {
    if (drawing()) cull(pipeline().drawing->cull);
    return;
  }
  gl_.UseProgram(pipeline().program);
  if (!drawing()) return;
  set_fixed_state(*pipeline().drawing);
  gl_.BindVertexArray(pipeline().vertex_array);
  auto own = std::static_pointer_cast<GlPipeline>(given);
  if (std::ranges::find(used_, own) == used_.end()) used_.push_back(std::move(own));
  for (VertexSlot& slot : vertices_)
    slot.changed = true;
  vertices_changed_ = indices_changed_ = true;
}

void GlEncoder::set_fixed_state(const PipelineDesc& desc) {
  if (desc.depth == Format::none) {
    gl_.Disable(GL_DEPTH_TEST);
  } else {
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(name(desc.depth_compare));
    gl_.DepthMask(desc.depth_write ? GL_TRUE : GL_FALSE);
  }
  cull(desc.cull);
  if (desc.blend == Blend::none) {
    gl_.Disable(GL_BLEND);
  } else {
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, desc.blend == Blend::over ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
  }
}

void GlEncoder::vertices(int binding, const BufferRef& buffer, std::size_t offset) {
  check_vertices(binding, buffer, offset);
  if (of(buffer, "a vertex binding").written) check_declared(pass(), buffer, false);
  const auto index = static_cast<std::size_t>(binding);
  if (vertices_.size() <= index) vertices_.resize(index + 1);
  vertices_[index] = {buffer, offset, true};
  vertices_changed_ = true;
}

void GlEncoder::indices(const BufferRef& buffer) {
  check_indices(buffer);
  if (of(buffer, "the indices").written) check_declared(pass(), buffer, false);
  indices_ = buffer;
  indices_changed_ = true;
}

void GlEncoder::cull(Cull cull) {
  if (cull == Cull::none) {
    gl_.Disable(GL_CULL_FACE);
    return;
  }
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(cull == Cull::back ? GL_BACK : GL_FRONT);
}

void GlEncoder::front_is_clockwise(bool clockwise) {
  gl_.FrontFace(clockwise ? GL_CW : GL_CCW);
}

void GlEncoder::draw(std::uint32_t vertex_count, std::uint32_t instance_count) {
  prepare(true);
  gl_.DrawArraysInstanced(GL_TRIANGLES, 0, static_cast<GLsizei>(vertex_count),
                          static_cast<GLsizei>(instance_count));
  ++context_->counters.draws;
}

void GlEncoder::draw_indexed(std::uint32_t index_count, std::uint32_t instance_count,
                             std::uint32_t first_index) {
  prepare(true);
  check_index_range(indices_, first_index, index_count);
  const std::size_t offset = std::size_t{first_index} * sizeof(std::uint32_t);
  if (indices_changed_) {
    gl_.VertexArrayElementBuffer(pipeline().vertex_array, of(indices_, "the indices").name);
    indices_changed_ = false;
  }
  gl_.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(index_count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(offset),
                            static_cast<GLsizei>(instance_count));
  ++context_->counters.draws;
}

void GlEncoder::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  prepare(false);
  check_dispatch(x, y, z, context_->limits(), pipeline().label);
  gl_.DispatchCompute(x, y, z);
  ++context_->counters.dispatches;
}

void GlEncoder::prepare(bool draws) {
  check_use(draws);
  if (resources_changed_) {
    for (std::size_t i = 0; i < applied_.size(); ++i) {
      const Slot& slot = pipeline().slots[i];
      const Bound& bound = bound_to(slot);
      if (applied_[i] == bound.version) continue;
      bind(slot, bound);
      applied_[i] = bound.version;
    }
    resources_changed_ = false;
  }
  if (draws && vertices_changed_) bind_vertices();
}

void GlEncoder::bind_vertices() {
  const std::vector<VertexBinding>& wanted = pipeline().drawing->bindings;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i >= vertices_.size() || !vertices_[i].buffer)
      refuse("nothing is bound to vertex binding " + std::to_string(i));
    VertexSlot& slot = vertices_[i];
    if (!slot.changed) continue;
    gl_.VertexArrayVertexBuffer(
        pipeline().vertex_array, static_cast<GLuint>(i), of(slot.buffer, "a vertex binding").name,
        static_cast<GLintptr>(slot.offset), static_cast<GLsizei>(wanted[i].stride));
    slot.changed = false;
  }
  vertices_changed_ = false;
}

} // namespace gg::gpu::opengl
