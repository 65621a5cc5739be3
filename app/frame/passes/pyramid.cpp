// The levels of the scene-colour pyramid, each from the one before: Gaussians of known variance
// (shaders/refraction/screen_pyramid.glsl).
#include "frame/passes/passes.h"

namespace gg::frame {

void declare_pyramid(Graph& graph, const SceneCopy& scene_copy) {
  if (!scene_copy.blurs) return;
  const std::size_t pyramid = scene_copy.pyramid.target;
  const auto prepare = [](Context& context) -> Record {
    gpu::PipelineRef halve = context.fullscreen(
        {.label = "pyramid", .fragment = "pyramid.frag", .colors = {color_format}});
    return [halve](gpu::Encoder& encoder) {
      encoder.use(halve);
      encoder.draw(3);
    };
  };
  for (int level = 1; level < graph.targets[pyramid].levels; ++level)
    graph.passes.push_back({.label = "pyramid",
                            .reads = {{"finer", {pyramid, level - 1}, gpu::Filter::linear}},
                            .colors = {{.part = {pyramid, level}}},
                            .prepare = prepare});
}

} // namespace gg::frame
