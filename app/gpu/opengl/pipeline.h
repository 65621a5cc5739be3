// Programs, their fixed state, and where each name is bound.
#pragma once

#include "gpu/checked_encoder.h"
#include "gpu/names.h"
#include "gpu/opengl/context.h"
#include "gpu/shaders/compile.h"
#include "gpu/types.h"

#include <span>
#include <string>

namespace gg::gpu::opengl {

struct GlPipeline final : BuiltPipeline {
  GlPipeline(ContextRef owner, Names& names, const PipelineDesc& desc);
  GlPipeline(ContextRef owner, Names& names, const ComputeDesc& desc);
  ~GlPipeline() override;

  ContextRef context;
  GLuint program = 0;
  GLuint vertex_array = 0; // 0: it computes

private:
  void build(Names& names, std::span<const std::string> stages,
             std::span<const Constant> constants);
  void lay_out_vertices(const shaders::Reflection& vertex_stage);
  void destroy() noexcept;
};

} // namespace gg::gpu::opengl
