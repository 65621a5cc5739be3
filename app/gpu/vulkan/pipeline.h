// Pipelines: compiled stages, their fixed state, and where each name is bound.
#pragma once

#include "gpu/names.h"
#include "gpu/shaders/compile.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/descriptors.h"
#include "gpu/vulkan/pipeline_cache.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gg::gpu::vulkan {

// One resource of a pipeline and the name it is asked for by.
struct Slot {
  int name = 0; // in Names
  shaders::Binding binding;
};

// What all pipelines of a device are made with.
struct PipelineKit {
  std::shared_ptr<Context> context;
  SetLayouts& layouts;
  PipelineCache& cache;
  Names& names;
};

struct GpuPipeline final : Pipeline {
  // Throw Error(internal) with the compiler's log, Error(device) if the driver fails.
  GpuPipeline(const PipelineKit& kit, const PipelineDesc& desc);
  GpuPipeline(const PipelineKit& kit, const ComputeDesc& desc);
  ~GpuPipeline() override;

  std::shared_ptr<Context> context;
  VkPipeline handle = VK_NULL_HANDLE;
  const SetLayout* layout = nullptr;
  std::vector<Slot> slots;             // by binding number
  std::optional<PipelineDesc> drawing; // none: it computes

private:
  struct Stages;
  shaders::Program link(const PipelineKit& kit, std::span<const std::string> stages,
                        std::span<const Constant> constants);
};

} // namespace gg::gpu::vulkan
