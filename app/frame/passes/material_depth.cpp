// The pixels that each opaque region shades, as a depth that the region's own is equal to.
#include "frame/passes/passes.h"
#include "frame/regions.h"

namespace gg::frame {

std::size_t material_depth(Graph& graph) {
  return graph.target({.name = "material depth", .format = depth_format});
}

void declare_material_depth(Graph& graph, const needs::Needs& needs,
                            const std::optional<NeighbourLight>& neighbours) {
  if (needs.opaque_regions.empty()) return;
  const auto prepare = [has_cells = neighbours.has_value()](Context& context) -> Record {
    gpu::PipelineRef find =
        context.draws.pipeline(gpu::PipelineDesc{.label = "material depth",
                                                 .vertex = "region.vert",
                                                 .fragment = "material_depth.frag",
                                                 .constants = {gpu::constant(0, has_cells)},
                                                 .depth = depth_format,
                                                 .depth_compare = gpu::Compare::always});
    return [&context, find](gpu::Encoder& encoder) {
      encoder.use(find);
      bind_region(encoder, context.regions, all_opaque_regions(context.needs));
      encoder.draw(6);
    };
  };
  graph.passes.push_back(
      {.label = "material depth",
       .reads = {{"geometry", {geometry_buffer(graph)}}, {"sceneDepth", {scene_depth(graph)}}},
       .depth = DepthOutput{material_depth(graph), 0.0f},
       .prepare = prepare});
  if (neighbours) graph.passes.back().reads.push_back(neighbours->cells);
}

} // namespace gg::frame
