// Opaque surfaces, the sky, and blended surfaces that lie over these alone.
#include "frame/passes/alike.h"
#include "frame/passes/passes.h"

#include <algorithm>
#include <iterator>

namespace gg::frame {
namespace {

// Alpha masks: a depth pass first, so that each pixel is shaded once however many leaves overlap.
void record_mask(Context& context, const DrawPass& opaque, const needs::Draw& draw, Records& depths,
                 Records& shaded) {
  depths.push_back(
      context.draws.recorded(hiding_pass("masks"), {&draw, needs::Faces::as_material}));
  DrawPass shade = opaque;
  shade.label = "masked";
  shade.depth_write = false;
  shade.depth_compare = gpu::Compare::equal;
  needs::Draw whole = draw;
  needs::set_value(whole.key, needs::Feature::alpha_mode,
                   static_cast<int>(scene::AlphaMode::opaque));
  shaded.push_back({&draw, context.draws.pipeline(shade, whole), depths.back().cull});
}

} // namespace

void declare_opaque(Graph& graph, const needs::Needs& needs) {
  const bool with_blended = !needs.shades_opaque_late();
  const auto prepare = [with_blended](Context& context) -> Record {
    const DrawPass opaque{.label = "opaque", .fragment = "opaque.frag", .colors = {color_format}};
    const DrawPass blended = blended_pass();
    Records records, masks, masked, over;
    for (const needs::Draw* draw : context.needs.opaque)
      if (draw->material->alpha_mode == scene::AlphaMode::mask)
        record_mask(context, opaque, *draw, masks, masked);
      else
        records.push_back(context.draws.recorded(opaque, {draw, needs::Faces::as_material}));
    std::ranges::copy(masks, std::back_inserter(records));
    std::ranges::copy(masked, std::back_inserter(records));
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
        encoder.cull(gpu::Cull::none); // whichever way the last mesh was turned
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
