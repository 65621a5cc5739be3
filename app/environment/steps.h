// The steps of building a stack as passes of the device.
#pragma once

#include "environment/stack_plan.h"
#include "gpu/device.h"

#include <string>
#include <vector>

namespace gg::environment {

class Steps {
public:
  explicit Steps(gpu::Device& device);

  struct Bound {
    const char* name;
    gpu::View view;
  };
  // All six faces, so many groups along each edge. Textures are read texel by texel.
  void add(const std::string& label, const gpu::PipelineRef& pipeline, const EnvironmentStep& step,
           std::vector<Bound> textures, std::vector<Bound> images, int groups_per_edge);
  // Those added since the last run.
  void run(std::vector<gpu::PassTime>* times);

private:
  gpu::Device& device_;
  gpu::SamplerRef point_;
  gpu::BufferRef blocks_; // of the run that is being recorded
  std::vector<EnvironmentStep> values_;
  std::vector<gpu::Pass> passes_;
};

} // namespace gg::environment
