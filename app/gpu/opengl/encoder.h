// Turns what a pass records into OpenGL calls, and leaves out those that change nothing.
#pragma once

#include "gpu/opengl/pipeline.h"
#include "gpu/opengl/resources.h"

#include <array>
#include <memory>
#include <vector>

namespace gg::gpu::opengl {

class GlEncoder final : public CheckedEncoder {
public:
  GlEncoder(ContextRef context, const Names& names)
      : CheckedEncoder(names), context_(std::move(context)), gl_(context_->gl()) {}

  void begin(const Pass& pass); // targets, clears, barriers
  void end() noexcept;          // lets go of everything that was bound

  void use(const PipelineRef& pipeline) override;
  void vertices(int binding, const BufferRef& buffer, std::size_t offset) override;
  void indices(const BufferRef& buffer) override;
  void cull(Cull cull) override;
  void front_is_clockwise(bool clockwise) override;
  void draw(std::uint32_t vertex_count, std::uint32_t instance_count) override;
  void draw_indexed(std::uint32_t index_count, std::uint32_t instance_count,
                    std::uint32_t first_index) override;
  void dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) override;

private:
  // What a unit of OpenGL holds, by serials, so that equal bindings are not made again.
  struct Unit {
    std::uint64_t object = 0, sampler = 0;
    std::size_t offset = 0, bytes = 0;
    bool operator==(const Unit&) const = default;
  };
  struct VertexSlot {
    BufferRef buffer;
    std::size_t offset = 0;
    bool changed = false;
  };

  void prepare(bool draws); // everything that the next draw or dispatch needs
  void bind(const Slot& slot, const Bound& bound);
  void bind_buffer(const Slot& slot, const Bound& bound);
  void bind_texture(const Slot& slot, const Bound& bound);
  void bind_image(const Slot& slot, const Bound& bound);
  bool unit_changes(const Slot& slot, const Unit& wanted);
  void bind_vertices();
  void bind_targets();
  void set_fixed_state(const PipelineDesc& desc);
  void detach_vertices() noexcept;

  ContextRef context_;
  const GladGLContext& gl_;
  GlPipeline& pipeline() const { return CheckedEncoder::pipeline<GlPipeline>(); }

  // In this pass, with buffers in their vertex arrays.
  std::vector<std::shared_ptr<GlPipeline>> used_;
  bool vertices_changed_ = false;

  std::array<std::vector<Unit>, 4> units_; // by kind
  std::vector<VertexSlot> vertices_;
  BufferRef indices_;
  bool indices_changed_ = false;

  std::vector<Attachment> colors_; // kept for its memory
};

} // namespace gg::gpu::opengl
