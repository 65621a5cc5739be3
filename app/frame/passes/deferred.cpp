// Shades the opaque regions: one quad for each material, where its meshes are in front.
#include "frame/passes/passes.h"
#include "frame/regions.h"
#include "needs/regions.h"

namespace gg::frame {
namespace {

// As what its pixels keep has it: no maps and no colours of vertices left to read, no alpha to test.
needs::Draw without_maps(const needs::Draw& draw) {
  needs::Draw plain = draw;
  for (const needs::MapKind& kind : needs::map_kinds)
    needs::set_value(plain.key, kind.feature, 0);
  needs::set_value(plain.key, needs::Feature::vertex_color, 0);
  needs::set_value(plain.key, needs::Feature::uv_sets, 0);
  needs::set_value(plain.key, needs::Feature::alpha_mode,
                   static_cast<int>(scene::AlphaMode::opaque));
  return plain;
}

} // namespace

void declare_deferred(Graph& graph, const needs::Needs& needs) {
  if (needs.opaque_regions.empty()) return;
  const auto prepare = [](Context& context) -> Record {
    const DrawPass pass{.label = "deferred",
                        .by_region = true,
                        .fragment = "opaque_region.frag",
                        .colors = {color_format},
                        .depth_write = false,
                        .depth_compare = gpu::Compare::equal};
    DrawPass with_maps = pass;
    with_maps.fragment = "opaque_region_maps.frag";
    std::vector<RecordedRegion> regions;
    for (const needs::Region& region : context.needs.opaque_regions) {
      const needs::Draw* draw = region.draws.front();
      const gpu::PipelineRef pipeline = needs::keeps_maps(*draw)
                                            ? context.draws.pipeline(with_maps, without_maps(*draw))
                                            : context.draws.pipeline(pass, *draw);
      regions.push_back({draw, pipeline, opaque_region(regions.size())});
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
  graph.passes.push_back(std::move(pass));
}

} // namespace gg::frame
