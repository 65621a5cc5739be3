// Adds a sample to the average of the frame.
#include "frame/passes/passes.h"

namespace gg::frame {

void declare_accumulate(Graph& graph, const needs::Needs& needs) {
  if (needs.view.samples == 1) return;
  const std::size_t average =
      graph.target({.name = "average", .format = color_format, .is_result = true});
  const auto prepare = [](Context& context) -> Record {
    gpu::PipelineRef add = context.fullscreen(
        {.label = "accumulate",
         .fragment = "accumulate.frag",
         .constants = {gpu::constant(0, 1.0f / static_cast<float>(context.needs.view.samples))},
         .colors = {color_format},
         .blend = gpu::Blend::add});
    return [add](gpu::Encoder& encoder) {
      encoder.use(add);
      encoder.draw(3);
    };
  };
  graph.passes.push_back(
      {.label = "accumulate",
       .reads = {{"sampleColor", {scene_color(graph)}}},
       .colors = {{.part = {average}, .clear = {{0, 0, 0, 0}}, .accumulates = true}},
       .prepare = prepare});
}

} // namespace gg::frame
