// Depth and normal of the fine opaque meshes, whose shading is deferred, and what their maps say.
#include "frame/passes/passes.h"
#include "frame/regions.h"
#include "needs/regions.h"

namespace gg::frame {
namespace {

bool keeps_maps(const needs::Region& region) {
  return needs::keeps_maps(*region.draws.front());
}

} // namespace

// Depth, normal and region as bits: stages/geometry.glsl.
std::size_t geometry_buffer(Graph& graph) {
  return graph.target({.name = "geometry", .format = gpu::Format::rgba32ui});
}

// stages/packed_maps.glsl.
std::size_t geometry_maps(Graph& graph) {
  return graph.target({.name = "geometry maps", .format = gpu::Format::rgba32ui});
}

void declare_geometry(Graph& graph, const needs::Needs& needs) {
  for (const bool maps : {false, true}) {
    std::size_t draws = 0;
    for (const needs::Region& region : needs.opaque_regions)
      if (keeps_maps(region) == maps) draws += region.draws.size();
    if (draws == 0) continue;
    const auto prepare = [maps](Context& context) -> Record {
      const DrawPass pass{.label = "geometry",
                          .fragment = maps ? "geometry_maps.frag" : "geometry.frag",
                          .colors = std::vector(maps ? 2u : 1u, gpu::Format::rgba32ui)};
      std::vector<std::pair<std::size_t, Records>> regions; // blocks
      for (std::size_t i = 0; i < context.needs.opaque_regions.size(); ++i) {
        const needs::Region& region = context.needs.opaque_regions[i];
        if (keeps_maps(region) != maps) continue;
        Records& records = regions.emplace_back(opaque_region(i), Records{}).second;
        for (const needs::Draw* draw : region.draws)
          records.push_back(context.draws.recorded(pass, {draw, needs::Faces::as_material}));
      }
      return [&context, regions](gpu::Encoder& encoder) {
        for (const auto& [block, records] : regions) {
          bind_region(encoder, context.regions, block);
          context.draws.record(encoder, records);
        }
      };
    };
    const bool first = !graph.is_written(geometry_buffer(graph));
    Pass pass{.label = "geometry",
              .draws = draws,
              .shades = maps,
              .colors = {{.part = {geometry_buffer(graph)}}},
              .depth = DepthOutput{scene_depth(graph)},
              .prepare = prepare};
    if (maps) pass.colors.push_back({.part = {geometry_maps(graph)}});
    if (first) {
      pass.colors.front().clear = {{0, 0, 0, 0}};
      pass.depth->clear = 0.0f;
    }
    graph.passes.push_back(std::move(pass));
  }
}

} // namespace gg::frame
