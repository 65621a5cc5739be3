// Opaque surfaces once more, now that the picture shows what they reflect; with `glass`, what shows the glass about it.
#include "frame/passes/passes.h"
#include "frame/regions.h"

#include <algorithm>

namespace gg::frame {
namespace {

constexpr std::uint32_t looks_around = 41; // constant of stages/surroundings.glsl

void declare_by_mesh(Graph& graph, const Pass& common, std::size_t draws, bool glass) {
  if (draws == 0) return;
  Pass pass = common;
  pass.draws = draws;
  pass.depth = DepthOutput{scene_depth(graph)};
  pass.prepare = [glass](Context& context) -> Record {
    const DrawPass draw_pass{.label = "reflective",
                             .fragment = "opaque.frag",
                             .colors = {color_format},
                             .depth_write = false,
                             .constants = {gpu::constant(looks_around, true)}};
    Records records;
    for (const needs::Draw* draw : context.needs.reflective)
      if (!glass || needs::shows_glass(*draw))
        records.push_back(context.draws.recorded(draw_pass, {draw, needs::Faces::as_material}));
    return [&context, records](gpu::Encoder& encoder) { context.draws.record(encoder, records); };
  };
  graph.passes.push_back(std::move(pass));
}

void declare_by_region(Graph& graph, const Pass& common, std::size_t draws, bool glass) {
  if (draws == 0) return;
  Pass pass = common;
  pass.draws = draws;
  pass.reads.push_back({"geometry", {geometry_buffer(graph)}});
  pass.depth = DepthOutput{material_depth(graph)};
  pass.prepare = [glass](Context& context) -> Record {
    const DrawPass draw_pass{.label = "deferred reflective",
                             .by_region = true,
                             .fragment = "opaque_region.frag",
                             .colors = {color_format},
                             .depth_write = false,
                             .depth_compare = gpu::Compare::equal,
                             .constants = {gpu::constant(looks_around, true)}};
    std::vector<RecordedRegion> regions;
    for (const needs::Region* region : context.needs.reflective_regions) {
      const needs::Draw* draw = region->draws.front();
      if (!glass || needs::shows_glass(*draw))
        regions.push_back({draw, context.draws.pipeline(draw_pass, *draw),
                           opaque_region(static_cast<std::size_t>(
                               region - context.needs.opaque_regions.data()))});
    }
    return [&context, regions](gpu::Encoder& encoder) {
      for (const RecordedRegion& region : regions)
        context.draws.shade(encoder, region, context.regions);
    };
  };
  graph.passes.push_back(std::move(pass));
}

} // namespace

// With `glass` its colour and depth are part of the picture by now, and it hides what is behind it.
void declare_reflective(Graph& graph, const needs::Needs& needs, bool glass) {
  if (!(glass ? needs.reflects_glass() : needs.reflects())) return;
  const Backdrop backdrop = declare_backdrop(graph, needs, needs.layers.size());
  declare_pyramid(graph, backdrop);
  if (glass && !needs.reflective_regions.empty()) declare_material_depth(graph, needs);
  const Pass common{.label = "reflective",
                    .shades = true,
                    .reads = backdrop.inputs(),
                    .colors = {{.part = {scene_color(graph)}}}};
  const auto shown = [glass](const needs::Draw& draw) { return !glass || shows_glass(draw); };
  const auto meshes = std::ranges::count_if(needs.reflective,
                                            [&](const needs::Draw* draw) { return shown(*draw); });
  const auto regions =
      std::ranges::count_if(needs.reflective_regions, [&](const needs::Region* region) {
        return shown(*region->draws.front());
      });
  declare_by_mesh(graph, common, static_cast<std::size_t>(meshes), glass);
  declare_by_region(graph, common, static_cast<std::size_t>(regions), glass);
}

} // namespace gg::frame
