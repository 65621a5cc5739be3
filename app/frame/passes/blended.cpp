// Blended surfaces over opaque ones that are shaded after the opaque pass.
#include "frame/passes/alike.h"
#include "frame/passes/passes.h"

#include <algorithm>
#include <iterator>

namespace gg::frame {

void declare_blended(Graph& graph, const needs::Needs& needs) {
  if (needs.over_opaque.empty() || !needs.shades_opaque_late()) return;
  const auto prepare = [](Context& context) -> Record {
    const DrawPass pass = blended_pass();
    Records records;
    for (const needs::LayerDraw& draw : context.needs.over_opaque)
      records.push_back(context.draws.recorded(pass, draw));
    if (!context.needs.layers.empty())
      std::ranges::copy(context.draws.covers(context.needs.over_opaque),
                        std::back_inserter(records));
    return [&context, records](gpu::Encoder& encoder) { context.draws.record(encoder, records); };
  };
  graph.passes.push_back({.label = "blended",
                          .draws = needs.over_opaque.size(),
                          .shades = true,
                          .colors = {{.part = {scene_color(graph)}}},
                          .depth = DepthOutput{scene_depth(graph)},
                          .prepare = prepare});
}

} // namespace gg::frame
