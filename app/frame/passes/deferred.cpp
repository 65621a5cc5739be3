// Shades the opaque regions: one quad for each material, where its meshes are in front.
#include "frame/passes/passes.h"
#include "frame/regions.h"

namespace gg::frame {

void declare_deferred(Graph& graph, const needs::Needs& needs) {
  if (needs.opaque_regions.empty()) return;
  const auto prepare = [](Context& context) -> Record {
    const DrawPass pass{.label = "deferred",
                        .by_region = true,
                        .fragment = "opaque_region.frag",
                        .colors = {color_format},
                        .depth_write = false,
                        .depth_compare = gpu::Compare::equal};
    std::vector<RecordedRegion> regions;
    for (const needs::Region& region : context.needs.opaque_regions) {
      const needs::Draw* draw = region.draws.front();
      regions.push_back({draw, context.draws.pipeline(pass, *draw), opaque_region(regions.size())});
    }
    return [&context, regions](gpu::Encoder& encoder) {
      for (const RecordedRegion& region : regions)
        context.draws.shade(encoder, region, context.regions);
    };
  };
  graph.passes.push_back({.label = "deferred",
                          .draws = needs.opaque_regions.size(),
                          .shades = true,
                          .reads = {{"geometry", {geometry_buffer(graph)}}},
                          .colors = {{.part = {scene_color(graph)}}},
                          .depth = DepthOutput{material_depth(graph)},
                          .prepare = prepare});
}

} // namespace gg::frame
