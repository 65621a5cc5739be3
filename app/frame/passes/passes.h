// The passes of a frame, one file each: when a pass is needed, what it reads and writes, its shaders, how it records.
// To add one: a file here, its declaration below, and its place in frame/declare.cpp.
#pragma once

#include "frame/context.h"

namespace gg::frame {

// What glass looks up behind it: the scene-colour pyramid, and depths.
struct SceneCopy {
  Part pyramid;
  bool blurs = false;               // with pyramid levels, and depth
  std::optional<Part> depth;        // that rays intersect
  std::optional<Part> hiding_depth; // of what hides regions of this layer
  std::vector<Input> inputs() const;
};

// The maps of needs/shadow_maps.h; and, once all passes are declared, that those which shade read them.
void declare_shadows(Graph& graph, const needs::Needs& needs);
void read_shadows(Graph& graph, const needs::Needs& needs);
void declare_geometry(Graph& graph, const needs::Needs& needs);
void declare_opaque(Graph& graph, const needs::Needs& needs);
// What neighbours add to opaque regions at the corners of cells, and the cells in which that is interpolated.
struct NeighbourLight {
  std::vector<Input> corners;
  Input cells;
};
std::optional<NeighbourLight> declare_neighbour_light(Graph& graph, const needs::Needs& needs);
void declare_material_depth(Graph& graph, const needs::Needs& needs,
                            const std::optional<NeighbourLight>& neighbours);
void declare_deferred(Graph& graph, const needs::Needs& needs,
                      const std::optional<NeighbourLight>& neighbours);
void declare_blended(Graph& graph, const needs::Needs& needs);
SceneCopy declare_scene_copy(Graph& graph, const needs::Needs& needs, std::size_t layer);
void declare_foreground(Graph& graph, const needs::Needs& needs, std::size_t layer,
                        const SceneCopy& scene_copy);
void declare_pyramid(Graph& graph, const SceneCopy& scene_copy);
// All faces that the layer's solids want; nothing if there are none.
std::optional<Input> declare_interior(Graph& graph, const needs::Needs& needs, std::size_t layer);
// One of `pairs` pairs: part 0 is the nearest front face, 1 the nearest back face, 2 and 3 the next of each. The solids must not
// hide each other on the screen. Returns the array of faces.
std::size_t declare_faces(Graph& graph, const std::vector<const needs::Draw*>& solids, int part,
                          int pairs);
// Solids of the layer that are shaded by region, besides those that declare_refractive draws.
bool is_split(const needs::Region& region);
void declare_glass(Graph& graph, const needs::Needs& needs, std::size_t layer,
                   const SceneCopy& scene_copy, const Input& interior);
void declare_refractive(Graph& graph, const needs::Needs& needs, std::size_t layer,
                        const std::optional<SceneCopy>& scene_copy,
                        const std::optional<Input>& interior);
void declare_accumulate(Graph& graph, const needs::Needs& needs);

// The buffers that the passes of opaque regions share: depth, normal and region of a pixel; what its maps say; and the depth by
// which a region finds its pixels.
std::size_t geometry_buffer(Graph& graph);
std::size_t geometry_maps(Graph& graph);
std::size_t material_depth(Graph& graph);
// A pass that writes a depth of its own for the region of each material: an early test for equal depth then finds its fragments.
struct RegionDepths {
  const char* label;
  const char* fragment;
  std::vector<gpu::Constant> constants;
  std::size_t (*block)(const needs::Needs& needs); // of all regions as one: regions.h
  std::size_t depth;                               // written
};
void declare_region_depths(Graph& graph, const RegionDepths& depths);
// Of a stage over stages/opaque_region.glsl; `interpolates` what neighbours add.
gpu::PipelineRef region_pipeline(const Context& context, const DrawPass& pass,
                                 const needs::Draw& draw, bool interpolates);

} // namespace gg::frame
