// A layer of glass, and blended surfaces among it.
#include "frame/passes/alike.h"
#include "frame/passes/passes.h"
#include "frame/regions.h"

#include <algorithm>

namespace gg::frame {
namespace {

bool is_wall(const needs::Draw& draw) {
  const auto of = [&](needs::Feature feature) { return value_of(draw.key, feature); };
  return needs::lobes_of(static_cast<needs::Method>(of(needs::Feature::method))) > 0
         && of(needs::Feature::transmission) == static_cast<int>(needs::Transmission::thin)
         && of(needs::Feature::dispersion) == 0 && !draw.is_straight();
}

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
                            .constants = glass_constants(context.needs)};
  const DrawPass blended = blended_pass();
  const DrawPass hides = hiding_pass("hides");
  // Walls of no thickness in two steps, which hold fewer registers than one.
  DrawPass transmission = refractive;
  transmission.label = "thin transmission";
  transmission.fragment = "thin_transmission.frag";
  DrawPass reflection = refractive;
  reflection.label = "thin reflection";
  reflection.fragment = "thin_reflection.frag";
  reflection.depth_write = false;
  reflection.depth_compare = gpu::Compare::equal;
  reflection.blend = gpu::Blend::add;
  DrawPass by_region = refractive;
  by_region.label = "refractive region";
  by_region.by_region = true;
  by_region.fragment = "refractive_region.frag";
  by_region.depth_write = false;
  by_region.depth_compare = gpu::Compare::less_equal;

  const needs::Layer& layer = context.needs.layers[l];
  std::vector<Solid> solids;
  for (std::size_t r = 0; r < layer.regions.size(); ++r) {
    const needs::Region& region = layer.regions[r];
    if (is_split(region)) continue;
    const needs::Draw* draw = region.draws.front();
    Solid solid{
        {}, {draw, context.draws.pipeline(by_region, *draw), layer_region(context.needs, l, r)}};
    for (const needs::Draw* part : region.draws)
      solid.hides.push_back(context.draws.recorded(hides, {part, needs::Faces::front}));
    solids.push_back(std::move(solid));
  }
  Records records;
  for (const needs::LayerDraw& draw : layer.refractive) {
    if (!is_wall(*draw.draw)) {
      records.push_back(context.draws.recorded(refractive, draw));
      continue;
    }
    records.push_back(context.draws.recorded(transmission, draw));
    records.push_back(context.draws.recorded(reflection, draw));
  }
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
                        const std::optional<SceneCopy>& scene_copy,
                        const std::optional<Input>& interior) {
  const needs::Layer& layer = needs.layers[l];
  const auto split = std::ranges::count_if(layer.regions, is_split);
  if (split > 0) declare_glass(graph, needs, l, *scene_copy, *interior);
  const std::size_t draws = layer.refractive.size() + layer.regions.size() + layer.blended.size()
                            - static_cast<std::size_t>(split);
  if (draws == 0) return;
  Pass pass{.label = scene_copy ? "refractive" : "blended",
            .draws = draws,
            .shades = true,
            .colors = {{.part = {scene_color(graph)}}},
            .depth = DepthOutput{scene_depth(graph)},
            .prepare = [l](Context& context) { return prepare(context, l); }};
  if (scene_copy) pass.reads = scene_copy->inputs();
  if (interior) pass.reads.push_back(*interior);
  graph.passes.push_back(std::move(pass));
}

} // namespace gg::frame
