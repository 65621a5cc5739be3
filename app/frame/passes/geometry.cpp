// Depth and normal of the fine opaque meshes, whose shading is deferred.
#include "frame/passes/passes.h"
#include "frame/regions.h"

namespace gg::frame {

// Two halves of a normal, depth and region as bits: stages/geometry.frag.
std::size_t geometry_buffer(Graph& graph) {
  return graph.target({.name = "geometry", .format = gpu::Format::rgba32ui});
}

void declare_geometry(Graph& graph, const needs::Needs& needs) {
  if (needs.opaque_regions.empty()) return;
  std::size_t draws = 0;
  for (const needs::Region& region : needs.opaque_regions)
    draws += region.draws.size();
  const auto prepare = [](Context& context) -> Record {
    const DrawPass pass{
        .label = "geometry", .fragment = "geometry.frag", .colors = {gpu::Format::rgba32ui}};
    std::vector<Records> regions;
    for (const needs::Region& region : context.needs.opaque_regions) {
      Records& records = regions.emplace_back();
      for (const needs::Draw* draw : region.draws)
        records.push_back(context.draws.recorded(pass, {draw, needs::Faces::as_material}));
    }
    return [&context, regions](gpu::Encoder& encoder) {
      for (std::size_t i = 0; i < regions.size(); ++i) {
        bind_region(encoder, context.regions, opaque_region(i));
        context.draws.record(encoder, regions[i]);
      }
    };
  };
  graph.passes.push_back({.label = "geometry",
                          .draws = draws,
                          .colors = {{.part = {geometry_buffer(graph)}, .clear = {{0, 0, 0, 0}}}},
                          .depth = DepthOutput{scene_depth(graph), 0.0f},
                          .prepare = prepare});
}

} // namespace gg::frame
