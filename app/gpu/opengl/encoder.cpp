#include "gpu/opengl/encoder.h"

#include "core/error.h"
#include "gpu/opengl/formats.h"

#include <algorithm>

namespace gg::gpu::opengl {
namespace {

using shaders::Kind;

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
  pass_ = &pass;
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
  if (!pass.colors.empty() || pass.depth) bind_targets();
}

void GlEncoder::bind_targets() {
  colors_.clear();
  for (const ColorTarget& target : pass_->colors)
    colors_.push_back(of(target.view.texture, pass_->label).attachment(target.view));
  Attachment depth;
  if (pass_->depth)
    depth = of(pass_->depth->view.texture, pass_->label).attachment(pass_->depth->view);
  const GLuint framebuffer =
      context_->framebuffers.find_or_make(*context_, colors_, depth, pass_->label);

  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  const Extent size = target_extent(*pass_);
  gl_.Viewport(0, 0, size.width, size.height);
  gl_.FrontFace(GL_CCW);
  gl_.DepthMask(GL_TRUE); // clears obey it
  for (std::size_t i = 0; i < pass_->colors.size(); ++i)
    if (const auto& clear = pass_->colors[i].clear)
      clear_color(gl_, framebuffer, static_cast<GLint>(i),
                  pass_->colors[i].view.texture->desc.format, *clear);
  if (pass_->depth && pass_->depth->clear)
    gl_.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &*pass_->depth->clear);
}

void GlEncoder::end() noexcept {
  if (!pass_->storage.empty() || !pass_->writes_buffers.empty()) ++context_->writes;
  for (const View& view : pass_->storage)
    static_cast<GlTexture&>(*view.texture).written = context_->writes;
  for (const BufferRef& buffer : pass_->writes_buffers)
    static_cast<GlBuffer&>(*buffer).written = context_->writes;
  detach_vertices();
  for (Bound& bound : bound_)
    bound = {};
  vertices_.clear();
  indices_.reset();
  pipeline_.reset();
  pass_ = nullptr;
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

void GlEncoder::refuse(const std::string& what) const {
  throw Error(ExitCode::internal,
              "pass '" + pass_->label + "'"
                  + (pipeline_ ? ", pipeline '" + pipeline_->label + "'" : ""),
              what);
}

void GlEncoder::use(const PipelineRef& pipeline) {
  if (!pipeline) refuse("is given no pipeline");
  if (pipeline == pipeline_) {
    if (pipeline_->drawing) cull(pipeline_->drawing->cull);
    return;
  }
  pipeline_ = std::static_pointer_cast<GlPipeline>(pipeline);
  const bool draws = !pass_->colors.empty() || pass_->depth;
  if (draws != pipeline_->drawing.has_value())
    refuse(draws ? "computes, but the pass draws" : "draws, but the pass computes");
  gl_.UseProgram(pipeline_->program);
  applied_.assign(pipeline_->slots.size(), 0);
  resources_changed_ = true;
  if (!draws) return;
  check_targets(*pipeline_->drawing, *pass_);
  set_fixed_state(*pipeline_->drawing);
  gl_.BindVertexArray(pipeline_->vertex_array);
  if (std::ranges::find(used_, pipeline_) == used_.end()) used_.push_back(pipeline_);
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

GlEncoder::Bound* GlEncoder::find(std::string_view name) {
  const int number = names_.find(name);
  if (number < 0) return nullptr;
  if (bound_.size() < names_.size()) bound_.resize(names_.size());
  Bound& bound = bound_[static_cast<std::size_t>(number)];
  bound.version = ++version_;
  resources_changed_ = true;
  return &bound;
}

void GlEncoder::buffer(std::string_view block, const BufferRef& buffer, std::size_t offset,
                       std::size_t bytes) {
  Bound* bound = find(block);
  if (!bound) return;
  const BufferDesc& desc = of(buffer, block).desc;
  if (offset % block_alignment != 0)
    refuse(std::string(block) + " starts at byte " + std::to_string(offset) + " of "
           + describe(desc) + ", which is no multiple of " + std::to_string(block_alignment));
  check_range(desc, offset, bytes);
  bound->what = Bound::What::buffer;
  bound->buffer = buffer;
  bound->offset = offset;
  bound->bytes = bytes ? bytes : desc.bytes - offset;
}

void GlEncoder::texture(std::string_view name, const View& view, const SamplerRef& sampler) {
  Bound* bound = find(name);
  if (!bound) return;
  check_view(view);
  if (!sampler) refuse(std::string(name) + " is given no sampler");
  bound->what = Bound::What::texture;
  bound->view = view;
  bound->sampler = sampler;
}

void GlEncoder::image(std::string_view name, const View& view) {
  Bound* bound = find(name);
  if (!bound) return;
  check_view(view);
  bound->what = Bound::What::image;
  bound->view = view;
}

void GlEncoder::vertices(int binding, const BufferRef& buffer, std::size_t offset) {
  const GlBuffer& given = of(buffer, "a vertex binding");
  if (binding < 0) refuse("has no vertex binding " + std::to_string(binding));
  if (!has(given.desc.use, Use::vertices))
    refuse(describe(given.desc) + " was not made for vertices");
  check_range(given.desc, offset, 1);
  if (given.written) check_declared(*pass_, buffer, false);
  const auto index = static_cast<std::size_t>(binding);
  if (vertices_.size() <= index) vertices_.resize(index + 1);
  vertices_[index] = {buffer, offset, true};
  vertices_changed_ = true;
}

void GlEncoder::indices(const BufferRef& buffer) {
  const GlBuffer& given = of(buffer, "the indices");
  if (!has(given.desc.use, Use::indices))
    refuse(describe(given.desc) + " was not made for indices");
  if (given.written) check_declared(*pass_, buffer, false);
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
  if (!indices_) refuse("draws with indices but has none");
  const std::size_t offset = std::size_t{first_index} * sizeof(std::uint32_t);
  check_range(indices_->desc, offset, std::size_t{index_count} * sizeof(std::uint32_t));
  if (indices_changed_) {
    gl_.VertexArrayElementBuffer(pipeline_->vertex_array, of(indices_, "the indices").name);
    indices_changed_ = false;
  }
  gl_.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(index_count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(offset),
                            static_cast<GLsizei>(instance_count));
  ++context_->counters.draws;
}

void GlEncoder::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  prepare(false);
  check_dispatch(x, y, z, context_->limits(), pipeline_->label);
  gl_.DispatchCompute(x, y, z);
  ++context_->counters.dispatches;
}

void GlEncoder::prepare(bool draws) {
  if (!pipeline_) refuse("uses no pipeline");
  if (draws != pipeline_->drawing.has_value())
    refuse(draws ? "draws with a pipeline that computes" : "computes with a pipeline that draws");
  if (resources_changed_) {
    for (std::size_t i = 0; i < applied_.size(); ++i) {
      const Slot& slot = pipeline_->slots[i];
      const auto number = static_cast<std::size_t>(slot.name);
      if (number >= bound_.size() || bound_[number].what == Bound::What::nothing)
        refuse("nothing is bound to " + slot.binding.name);
      const Bound& bound = bound_[number];
      if (applied_[i] == bound.version) continue;
      bind(slot, bound);
      applied_[i] = bound.version;
    }
    resources_changed_ = false;
  }
  if (draws && vertices_changed_) bind_vertices();
}

void GlEncoder::bind_vertices() {
  const std::vector<VertexBinding>& wanted = pipeline_->drawing->bindings;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i >= vertices_.size() || !vertices_[i].buffer)
      refuse("nothing is bound to vertex binding " + std::to_string(i));
    VertexSlot& slot = vertices_[i];
    if (!slot.changed) continue;
    gl_.VertexArrayVertexBuffer(
        pipeline_->vertex_array, static_cast<GLuint>(i), of(slot.buffer, "a vertex binding").name,
        static_cast<GLintptr>(slot.offset), static_cast<GLsizei>(wanted[i].stride));
    slot.changed = false;
  }
  vertices_changed_ = false;
}

} // namespace gg::gpu::opengl
