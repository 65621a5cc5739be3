// What passes share when they make pipelines and record.
#pragma once

#include "frame/draws.h"
#include "frame/graph.h"
#include "frame/uniform_array.h"
#include "gpu/device.h"
#include "needs/needs.h"

#include <string>

namespace gg::frame {

// Colours keep 32 bits: scene radiance beyond half floats' range (a sun is above 100,000), and its blur and mean with it.
inline constexpr gpu::Format color_format = gpu::Format::rgba32f;
inline constexpr gpu::Format depth_format = gpu::Format::depth32f;

struct Context {
  gpu::Device& device;
  const needs::Needs& needs;
  Draws& draws;
  const UniformArray& regions;       // of the blocks in frame/regions.h
  const UniformArray& shadow_frames; // of each shadow view (frame/shadow_blocks.h)

  // A pipeline that covers its targets without a mesh.
  gpu::PipelineRef fullscreen(gpu::PipelineDesc desc) const {
    desc.vertex = "fullscreen.vert";
    return draws.pipeline(desc);
  }
};

// The targets that most passes share.
inline std::size_t scene_color(Graph& graph) {
  return graph.target({.name = "scene color", .format = color_format});
}
inline std::size_t scene_depth(Graph& graph) {
  return graph.target({.name = "scene depth", .format = depth_format});
}

} // namespace gg::frame
