// The pipelines of a frame of a scene, without a GPU.
#pragma once

#include "gpu/types.h"
#include "needs/features.h"
#include "scene/scene.h"

#include <vector>

namespace gg::test {

// In an environment; 64 x 64 pixels, one sample.
std::vector<gpu::PipelineDesc> pipelines_of(const scene::Scene& scene, needs::Method method);

} // namespace gg::test
