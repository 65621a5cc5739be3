// Programs, their fixed state, and where each name is bound.
#pragma once

#include "gpu/names.h"
#include "gpu/opengl/context.h"
#include "gpu/shaders/compile.h"
#include "gpu/types.h"

#include <optional>
#include <vector>

namespace gg::gpu::opengl {

// One resource of a pipeline: the name it is asked for by, and the unit it is bound to.
struct Slot {
  int name = 0; // in Names
  GLuint unit = 0;
  shaders::Binding binding;
};

struct GlPipeline final : Pipeline {
  GlPipeline(ContextRef owner, Names& names, const PipelineDesc& desc);
  GlPipeline(ContextRef owner, Names& names, const ComputeDesc& desc);
  ~GlPipeline() override;

  ContextRef context;
  GLuint program = 0;
  std::vector<Slot> slots;
  std::optional<PipelineDesc> drawing; // none: it computes
  GLuint vertex_array = 0;             // 0: it computes

private:
  void build(Names& names, std::span<const std::string> stages,
             std::span<const Constant> constants);
  void lay_out_vertices(const shaders::Reflection& vertex_stage);
  void destroy() noexcept;
};

} // namespace gg::gpu::opengl
