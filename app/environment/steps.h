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
  // Those added and not run yet: all of them, or the first of them. Returns how many are left.
  void run(std::vector<gpu::PassTime>* times);
  std::size_t run_one();

private:
  void upload_blocks();
  void clear();

  gpu::Device& device_;
  gpu::SamplerRef point_;
  gpu::BufferRef blocks_; // of those that are being run; null: none is
  std::vector<EnvironmentStep> values_;
  std::vector<gpu::Pass> passes_;
  std::size_t ran_ = 0; // of passes_
};

} // namespace gg::environment
