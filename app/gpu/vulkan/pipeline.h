// Pipelines: compiled stages, their fixed state, and where each name is bound.
#pragma once

#include "gpu/checked_encoder.h"
#include "gpu/names.h"
#include "gpu/shaders/compile.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/descriptors.h"
#include "gpu/vulkan/pipeline_cache.h"

#include <memory>
#include <span>
#include <string>

namespace gg::gpu::vulkan {

// What all pipelines of a device are made with.
struct PipelineKit {
  std::shared_ptr<Context> context;
  SetLayouts& layouts;
  PipelineCache& cache;
  Names& names;
};

struct GpuPipeline final : BuiltPipeline { // slots by binding number
  // Throw Error(internal) with the compiler's log, Error(device) if the driver fails.
  GpuPipeline(const PipelineKit& kit, const PipelineDesc& desc);
  GpuPipeline(const PipelineKit& kit, const ComputeDesc& desc);
  ~GpuPipeline() override;

  std::shared_ptr<Context> context;
  VkPipeline handle = VK_NULL_HANDLE;
  const SetLayout* layout = nullptr;

private:
  struct Stages;
  shaders::Program link(const PipelineKit& kit, std::span<const std::string> stages,
                        std::span<const Constant> constants);
};

} // namespace gg::gpu::vulkan
