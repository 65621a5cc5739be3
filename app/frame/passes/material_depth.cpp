// The pixels that each opaque region shades, as a depth that the region's own is equal to.
#include "frame/passes/passes.h"
#include "frame/regions.h"

namespace gg::frame {

std::size_t material_depth(Graph& graph) {
  return graph.target({.name = "material depth", .format = depth_format});
}

void declare_region_depths(Graph& graph, const RegionDepths& depths) {
  const auto prepare = [depths](Context& context) -> Record {
    gpu::PipelineRef find =
        context.draws.pipeline(gpu::PipelineDesc{.label = depths.label,
                                                 .vertex = "region.vert",
                                                 .fragment = depths.fragment,
                                                 .constants = depths.constants,
                                                 .depth = depth_format,
                                                 .depth_compare = gpu::Compare::always});
    return [&context, find, block = depths.block](gpu::Encoder& encoder) {
      encoder.use(find);
      bind_region(encoder, context.regions, block(context.needs));
      encoder.draw(6);
    };
  };
  graph.passes.push_back(
      {.label = depths.label,
       .reads = {{"geometry", {geometry_buffer(graph)}}, {"sceneDepth", {scene_depth(graph)}}},
       .depth = DepthOutput{depths.depth, 0.0f},
       .prepare = prepare});
}

void declare_material_depth(Graph& graph, const needs::Needs& needs,
                            const std::optional<NeighbourLight>& neighbours) {
  if (needs.opaque_regions.empty()) return;
  declare_region_depths(graph, {.label = "material depth",
                                .fragment = "material_depth.frag",
                                .constants = {gpu::constant(0, neighbours.has_value())},
                                .block = all_opaque_regions,
                                .depth = material_depth(graph)});
  if (neighbours) graph.passes.back().reads.push_back(neighbours->cells);
}

} // namespace gg::frame
