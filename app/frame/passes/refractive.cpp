// A layer of glass, and blended surfaces among it.
#include "frame/passes/passes.h"
#include "frame/regions.h"

namespace gg::frame {
namespace {

constexpr std::uint32_t looks_around = 41, most_bounces = 42; // constants of the glass stages

// A solid that is shaded by region: its front faces into the depth first, which hide what is behind it.
struct Solid {
  Records hides;
  RecordedRegion region;
};

Record prepare(Context& context, std::size_t l) {
  const DrawPass refractive{.label = "refractive",
                            .fragment = "refractive.frag",
                            .colors = {color_format},
                            .blend = gpu::Blend::over,
                            .constants = {gpu::constant(looks_around, context.needs.company),
                                          gpu::constant(most_bounces, needs::most_bounces)}};
  const DrawPass blended{.label = "blended",
                         .fragment = "opaque.frag",
                         .colors = {color_format},
                         .depth_write = false,
                         .blend = gpu::Blend::over};
  const DrawPass hides{.label = "hides",
                       .fragment = "foreground.frag",
                       .colors = {color_format},
                       .blend = gpu::Blend::over};
  DrawPass by_region = refractive;
  by_region.label = "refractive region";
  by_region.by_region = true;
  by_region.fragment = "refractive_region.frag";
  by_region.depth_write = false;
  by_region.depth_compare = gpu::Compare::less_equal;

  const needs::Layer& layer = context.needs.layers[l];
  std::vector<Solid> solids;
  for (const needs::Region& region : layer.regions) {
    const needs::Draw* draw = region.draws.front();
    Solid solid{{},
                {draw, context.draws.pipeline(by_region, *draw),
                 layer_region(context.needs, l, solids.size())}};
    for (const needs::Draw* part : region.draws)
      solid.hides.push_back(context.draws.recorded(hides, {part, needs::Faces::front}));
    solids.push_back(std::move(solid));
  }
  Records records;
  for (const needs::LayerDraw& draw : layer.refractive)
    records.push_back(context.draws.recorded(refractive, draw));
  for (const needs::LayerDraw& draw : layer.blended)
    records.push_back(context.draws.recorded(blended, draw));
  return [&context, solids, records](gpu::Encoder& encoder) {
    for (const Solid& solid : solids) {
      context.draws.record(encoder, solid.hides);
      context.draws.shade(encoder, solid.region, context.regions);
    }
    context.draws.record(encoder, records);
  };
}

} // namespace

void declare_refractive(Graph& graph, const needs::Needs& needs, std::size_t l,
                        const std::optional<Backdrop>& backdrop,
                        const std::optional<Input>& interior) {
  const needs::Layer& layer = needs.layers[l];
  Pass pass{.label = backdrop ? "refractive" : "blended",
            .draws = layer.refractive.size() + layer.regions.size() + layer.blended.size(),
            .shades = true,
            .colors = {{.part = {scene_color(graph)}}},
            .depth = DepthOutput{scene_depth(graph)},
            .prepare = [l](Context& context) { return prepare(context, l); }};
  if (backdrop) pass.reads = backdrop->inputs();
  if (interior) pass.reads.push_back(*interior);
  graph.passes.push_back(std::move(pass));
}

} // namespace gg::frame
