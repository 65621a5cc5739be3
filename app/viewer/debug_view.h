// What a picture is made of, in the picture's place: normals, depth, and what solids the line of sight runs through.
#pragma once

#include "gpu/device.h"
#include "image/image.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gg::viewer {

enum class DebugKind {
  picture,
  normals,
  depth,
  interior_layers,
  path_length,
  sigma_in_pixels, // of the lobe that passes, where it meets something; this one and those below: sight.h
  screen_share, // of that lobe: what meets something that the picture shows
  samples       // a pixel's lookups of pyramid and environment in all its samples
};
inline constexpr const char* debug_names[] = {
    "picture",         "normals",      "depth",  "interior layers", "path length inside",
    "sigma in pixels", "screen share", "samples"};

class DebugView {
public:
  explicit DebugView(gpu::Device& device) : device_(device) {}

  struct Drawn {
    image::Image colours; // for display
    double greatest =
        0.0; // what the brightest colour stands for: metres, layers, pixels or lookups
  };
  // Straight along the line of sight, from outside of solids; meshes as the picture culls them. Normals to path_length.
  Drawn draw(DebugKind kind, const scene::Scene& scene, const scene::Camera& camera, int width,
             int height);

private:
  struct Mesh {
    gpu::BufferRef positions, normals, indices;
    std::uint32_t count = 0;
  };
  const Mesh& mesh(const scene::Scene& scene, const scene::Primitive& primitive);

  gpu::Device& device_;
  std::map<const scene::Primitive*, Mesh> meshes_;
  gpu::PipelineRef surfaces_, sums_;
  gpu::TextureRef values_, depth_;
  gpu::BufferRef blocks_;
};

} // namespace gg::viewer
