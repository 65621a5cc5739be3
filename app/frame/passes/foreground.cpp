// Cuts bodies in front of a layer out of its scene copy: a blur must not include them.
#include "frame/passes/passes.h"

namespace gg::frame {

void declare_foreground(Graph& graph, const needs::Needs& needs, std::size_t layer,
                        const SceneCopy& scene_copy) {
  if (!scene_copy.blurs || needs.layers[layer].foreground.empty()) return;
  const auto prepare = [layer](Context& context) -> Record {
    const DrawPass pass{.label = "foreground",
                        .fragment = "foreground.frag",
                        .colors = {color_format},
                        .depth_write = false};
    Records records;
    for (const needs::Draw* draw : context.needs.layers[layer].foreground)
      records.push_back(context.draws.recorded(pass, {draw, needs::Faces::as_material}));
    return [&context, records](gpu::Encoder& encoder) { context.draws.record(encoder, records); };
  };
  graph.passes.push_back({.label = "foreground",
                          .draws = needs.layers[layer].foreground.size(),
                          .shades = true,
                          .colors = {{.part = {scene_copy.pyramid.target, 0}}},
                          .depth = DepthOutput{scene_depth(graph)},
                          .prepare = prepare});
}

} // namespace gg::frame
