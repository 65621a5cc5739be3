// What hides what is behind it, the sky, and blended surfaces that lie over these alone.
#include "frame/passes/alike.h"
#include "frame/passes/passes.h"

#include <algorithm>
#include <iterator>

namespace gg::frame {

void declare_opaque(Graph& graph, const needs::Needs& needs) {
  const bool with_blended = !needs.shades_opaque_late();
  const auto prepare = [with_blended](Context& context) -> Record {
    const DrawPass opaque{.label = "opaque", .fragment = "opaque.frag", .colors = {color_format}};
    const DrawPass blended = blended_pass();
    Records records, over;
    for (const needs::Draw* draw : context.needs.opaque)
      records.push_back(context.draws.recorded(opaque, {draw, needs::Faces::as_material}));
    if (with_blended)
      for (const needs::LayerDraw& draw : context.needs.over_opaque)
        over.push_back(context.draws.recorded(blended, draw));
    if (with_blended && !context.needs.layers.empty())
      std::ranges::copy(context.draws.covers(context.needs.over_opaque), std::back_inserter(over));
    gpu::PipelineRef sky;
    if (context.needs.sky)
      sky = context.fullscreen({.label = "sky",
                                .fragment = "sky.frag",
                                .colors = {color_format},
                                .depth = depth_format,
                                .depth_write = false});
    return [&context, records, over, sky](gpu::Encoder& encoder) {
      context.draws.record(encoder, records);
      if (sky) {
        encoder.use(sky);
        encoder.draw(3);
      }
      context.draws.record(encoder, over);
    };
  };
  Pass pass{.label = "opaque",
            .draws = needs.opaque.size() + (with_blended ? needs.over_opaque.size() : 0),
            .shades = true,
            .colors = {{.part = {scene_color(graph)}, .clear = {{0, 0, 0, 0}}}},
            .depth = DepthOutput{scene_depth(graph)},
            .prepare = prepare};
  if (needs.opaque_regions.empty()) pass.depth->clear = 0.0f; // else they are in it by now
  graph.passes.push_back(std::move(pass));
}

} // namespace gg::frame
