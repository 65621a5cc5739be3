// Shades the opaque regions: one quad for each material, where its meshes are in front; two where what neighbours add is
// interpolated in parts of it.
#include "frame/passes/passes.h"
#include "frame/regions.h"
#include "needs/regions.h"

namespace gg::frame {

gpu::PipelineRef region_pipeline(const Context& context, const DrawPass& pass,
                                 const needs::Draw& draw, bool interpolates) {
  constexpr std::uint32_t keeps_maps = 56; // constant of stages/opaque_region.glsl
  DrawPass with = pass;
  with.constants.push_back(gpu::constant(keeps_maps, needs::keeps_maps(draw)));
  needs::Draw shaded = draw;
  set_value(shaded.key, needs::Feature::interpolated_neighbours, interpolates);
  return context.draws.pipeline(with, shaded);
}

void declare_deferred(Graph& graph, const needs::Needs& needs,
                      const std::optional<NeighbourLight>& neighbours) {
  if (needs.opaque_regions.empty()) return;
  const auto prepare = [](Context& context) -> Record {
    const DrawPass pass{.label = "deferred",
                        .by_region = true,
                        .fragment = "opaque_region.frag",
                        .colors = {color_format},
                        .depth_write = false,
                        .depth_compare = gpu::Compare::equal};
    std::vector<RecordedRegion> regions;
    for (std::size_t i = 0; i < context.needs.opaque_regions.size(); ++i) {
      const needs::Draw* draw = context.needs.opaque_regions[i].draws.front();
      regions.push_back({draw, region_pipeline(context, pass, *draw, false), opaque_region(i)});
      if (needs::interpolates_neighbours(*draw))
        regions.push_back({draw, region_pipeline(context, pass, *draw, true),
                           interpolated_region(context.needs, i)});
    }
    return [&context, regions](gpu::Encoder& encoder) {
      for (const RecordedRegion& region : regions)
        context.draws.shade(encoder, region, context.regions);
    };
  };
  Pass pass{.label = "deferred",
            .draws = needs.opaque_regions.size(),
            .shades = true,
            .reads = {{"geometry", {geometry_buffer(graph)}}},
            .colors = {{.part = {scene_color(graph)}}},
            .depth = DepthOutput{material_depth(graph)},
            .prepare = prepare};
  if (graph.find("geometry maps")) pass.reads.push_back({"geometryMaps", {geometry_maps(graph)}});
  if (neighbours)
    pass.reads.insert(pass.reads.end(), neighbours->corners.begin(), neighbours->corners.end());
  graph.passes.push_back(std::move(pass));
}

} // namespace gg::frame
