// Shadow maps: depth of casters in each view of a light; where there is glass, its depth and its optical depth per channel. Once for a frame: samples of a pixel move the camera, not the lights.
#include "frame/passes/passes.h"

namespace gg::frame {
namespace {

constexpr gpu::Format tint_format =
    gpu::Format::rgba32f; // sums of what absorbs, which cancel from face to face

Target map(const needs::ShadowMaps& maps, const char* name, gpu::Format format) {
  return {.name = name,
          .format = format,
          .width = maps.size,
          .height = maps.size,
          .layers = static_cast<int>(maps.views.size()),
          .array = true,
          .is_result = true};
}

std::size_t depth_of_casters(Graph& graph, const needs::ShadowMaps& maps) {
  return graph.target(map(maps, "shadow depth", depth_format));
}
std::size_t depth_of_glass(Graph& graph, const needs::ShadowMaps& maps) {
  return graph.target(map(maps, "shadow glass depth", depth_format));
}
std::size_t tint(Graph& graph, const needs::ShadowMaps& maps) {
  return graph.target(map(maps, "shadow tint", tint_format));
}

// Both faces: what is not closed casts from either side.
Records records_of(Context& context, const DrawPass& pass, const std::vector<needs::Draw>& draws) {
  Records records;
  for (const needs::Draw& draw : draws) {
    records.push_back(context.draws.recorded(pass, {&draw, needs::Faces::as_material}));
    records.back().cull = gpu::Cull::none;
  }
  return records;
}

using Prepare = std::function<Record(Context&)>;

Prepare draws_from(std::size_t view, const DrawPass& pass,
                   std::vector<needs::Draw> needs::ShadowMaps::*draws) {
  return [=](Context& context) -> Record {
    const Records records = records_of(context, pass, context.needs.shadows.*draws);
    return [&context, view, records](gpu::Encoder& encoder) {
      const UniformArray& frames = context.shadow_frames;
      encoder.buffer("Frame", frames.buffer, frames.offset(view), frames.size);
      context.draws.record(encoder, records);
    };
  };
}

} // namespace

void declare_shadows(Graph& graph, const needs::Needs& needs) {
  const needs::ShadowMaps& maps = needs.shadows;
  for (std::size_t v = 0; v < maps.views.size(); ++v) {
    const int layer = static_cast<int>(v);
    const DrawPass depth{.label = "shadow", .fragment = "shadow.frag"};
    graph.passes.push_back({.label = "shadow",
                            .draws = maps.casters.size(),
                            .shades = true,
                            .once = true,
                            .depth = DepthOutput{depth_of_casters(graph, maps), 0.0f, layer},
                            .prepare = draws_from(v, depth, &needs::ShadowMaps::casters)});
    if (maps.filters.empty()) continue;
    graph.passes.push_back({.label = "shadow glass",
                            .draws = maps.filters.size(),
                            .shades = true,
                            .once = true,
                            .depth = DepthOutput{depth_of_glass(graph, maps), 0.0f, layer},
                            .prepare = draws_from(v, depth, &needs::ShadowMaps::filters)});
    const DrawPass tinted{.label = "shadow tint",
                          .fragment = "shadow_tint.frag",
                          .colors = {tint_format},
                          .depth = gpu::Format::none,
                          .blend = gpu::Blend::add};
    graph.passes.push_back(
        {.label = "shadow tint",
         .draws = maps.filters.size(),
         .shades = true,
         .once = true,
         .colors = {{.part = {tint(graph, maps), 0, layer}, .clear = {{0, 0, 0, 0}}}},
         .prepare = draws_from(v, tinted, &needs::ShadowMaps::filters)});
  }
}

void read_shadows(Graph& graph, const needs::Needs& needs) {
  if (needs.shadows.views.empty()) return;
  const std::size_t depth = depth_of_casters(graph, needs.shadows);
  for (Pass& pass : graph.passes) {
    if (!pass.shades || pass.once) continue;
    pass.reads.push_back({"shadowDepth", {depth}});
    if (needs.shadows.filters.empty()) continue;
    pass.reads.push_back({"shadowGlassDepth", {depth_of_glass(graph, needs.shadows)}});
    pass.reads.push_back({"shadowTint", {tint(graph, needs.shadows)}});
  }
}

} // namespace gg::frame
