// What neighbours add to the light of opaque regions, at the corners of cells of 4 x 4 pixels, and the cells in which that is
// interpolated. Where they do not agree, regions are shaded with their neighbours at every pixel (passes/deferred.cpp).
#include "frame/passes/passes.h"
#include "frame/regions.h"
#include "needs/regions.h"

#include <algorithm>

namespace gg::frame {
namespace {

std::size_t of_corners(Graph& graph, const char* name, gpu::Format format = color_format) {
  return graph.target({.name = name,
                       .format = format,
                       .width = corners_of(graph.width),
                       .height = corners_of(graph.height)});
}

// A region's draws have the same material and the same neighbours.
bool interpolates(const needs::Region& region) {
  return needs::interpolates_neighbours(*region.draws.front());
}

void declare_light(Graph& graph, const needs::Needs& needs, std::size_t depth,
                   const std::vector<Input>& light) {
  const auto prepare = [](Context& context) -> Record {
    const DrawPass pass{.label = "neighbour light",
                        .by_region = true,
                        .fragment = "neighbour_light.frag",
                        .colors = std::vector(3, color_format),
                        .depth_write = false,
                        .depth_compare = gpu::Compare::equal};
    std::vector<RecordedRegion> regions;
    for (std::size_t i = 0; i < context.needs.opaque_regions.size(); ++i) {
      if (!interpolates(context.needs.opaque_regions[i])) continue;
      const needs::Draw& draw = *context.needs.opaque_regions[i].draws.front();
      regions.push_back(
          {&draw, region_pipeline(context, pass, draw, false), opaque_corners(context.needs, i)});
    }
    return [&context, regions](gpu::Encoder& encoder) {
      for (const RecordedRegion& region : regions)
        context.draws.shade(encoder, region, context.regions);
    };
  };
  Pass pass{.label = "neighbour light",
            .shades = true,
            .reads = {{"geometry", {geometry_buffer(graph)}}},
            .depth = DepthOutput{depth},
            .prepare = prepare};
  pass.draws = static_cast<std::size_t>(std::ranges::count_if(needs.opaque_regions, interpolates));
  if (graph.find("geometry maps")) pass.reads.push_back({"geometryMaps", {geometry_maps(graph)}});
  for (const Input& target : light)
    pass.colors.push_back({.part = target.part, .clear = {{0, 0, 0, 0}}});
  graph.passes.push_back(std::move(pass));
}

void declare_cells(Graph& graph, const std::vector<Input>& light, const Input& cells) {
  Pass pass{.label = "neighbour cells",
            .reads = light,
            .colors = {{.part = cells.part}},
            .prepare = [](Context& context) -> Record {
              gpu::PipelineRef agree = context.fullscreen({.label = "neighbour cells",
                                                           .fragment = "neighbour_cells.frag",
                                                           .colors = {color_format}});
              return [agree](gpu::Encoder& encoder) {
                encoder.use(agree);
                encoder.draw(3);
              };
            }};
  pass.reads.push_back({"geometry", {geometry_buffer(graph)}});
  graph.passes.push_back(std::move(pass));
}

} // namespace

std::optional<NeighbourLight> declare_neighbour_light(Graph& graph, const needs::Needs& needs) {
  if (std::ranges::none_of(needs.opaque_regions, interpolates)) return std::nullopt;
  const std::size_t depth = of_corners(graph, "neighbour corners", depth_format);
  NeighbourLight light{
      .corners = {{"neighbourIrradiance", {of_corners(graph, "neighbour irradiance")}},
                  {"neighbourReflected", {of_corners(graph, "neighbour reflected")}}},
      .cells = {"neighbourCells",
                {graph.target({.name = "neighbour cells",
                               .format = color_format,
                               .width = corners_of(graph.width) - 1,
                               .height = corners_of(graph.height) - 1})}}};
  std::vector<Input> all = light.corners;
  all.push_back({"neighbourSent", {of_corners(graph, "neighbour sent")}});
  declare_region_depths(graph, {.label = "neighbour corners",
                                .fragment = "neighbour_corners.frag",
                                .constants = {},
                                .block = all_opaque_corners,
                                .depth = depth});
  declare_light(graph, needs, depth, all);
  declare_cells(graph, all, light.cells);
  for (Input& corner : light.corners)
    corner.filter = gpu::Filter::linear;
  return light;
}

} // namespace gg::frame
