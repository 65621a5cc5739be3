// Turns what a pass records into OpenGL calls, and leaves out those that change nothing.
#pragma once

#include "gpu/opengl/pipeline.h"
#include "gpu/opengl/resources.h"

#include <array>
#include <memory>
#include <vector>

namespace gg::gpu::opengl {

class GlEncoder final : public Encoder {
public:
  GlEncoder(ContextRef context, Names& names)
      : context_(std::move(context)), gl_(context_->gl()), names_(names) {}

  void begin(const Pass& pass); // targets, clears, barriers
  void end() noexcept;          // lets go of everything that was bound

  void use(const PipelineRef& pipeline) override;
  void buffer(std::string_view block, const BufferRef& buffer, std::size_t offset,
              std::size_t bytes) override;
  void texture(std::string_view name, const View& view, const SamplerRef& sampler) override;
  void image(std::string_view name, const View& view) override;
  void vertices(int binding, const BufferRef& buffer, std::size_t offset) override;
  void indices(const BufferRef& buffer) override;
  void cull(Cull cull) override;
  void front_is_clockwise(bool clockwise) override;
  void draw(std::uint32_t vertex_count, std::uint32_t instance_count) override;
  void draw_indexed(std::uint32_t index_count, std::uint32_t instance_count,
                    std::uint32_t first_index) override;
  void dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) override;

private:
  // What is bound by a name. Set anew, it gets a new version.
  struct Bound {
    enum class What { nothing, buffer, texture, image } what = What::nothing;
    std::uint64_t version = 0;
    BufferRef buffer;
    std::size_t offset = 0, bytes = 0;
    View view;
    SamplerRef sampler;
  };
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

  Bound* find(std::string_view name);
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
  [[noreturn]] void refuse(const std::string& what) const;

  ContextRef context_;
  const GladGLContext& gl_;
  Names& names_;
  const Pass* pass_ = nullptr;

  std::shared_ptr<GlPipeline> pipeline_;
  std::vector<std::shared_ptr<GlPipeline>>
      used_;                           // in this pass, with buffers in their vertex arrays
  std::vector<Bound> bound_;           // by number of the name
  std::vector<std::uint64_t> applied_; // by slot of the pipeline: the version that is bound
  std::uint64_t version_ = 0;
  bool resources_changed_ = false, vertices_changed_ = false;

  std::array<std::vector<Unit>, 4> units_; // by kind
  std::vector<VertexSlot> vertices_;
  BufferRef indices_;
  bool indices_changed_ = false;

  std::vector<Attachment> colors_; // kept for its memory
};

} // namespace gg::gpu::opengl
