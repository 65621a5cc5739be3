// What the shading of fine meshes takes from them, pixel by pixel: depth, normal, and which region shades the pixel
// (stages/geometry.frag).
#pragma once

#include "gpu/device.h"

#include <cstddef>
#include <functional>

namespace gg::frame {

class GeometryBuffer {
public:
  static constexpr gpu::Format texel_format = gpu::Format::rgba32ui;

  // The depth by which the n-th region finds its pixels: exact in floats, and never 0, which is nowhere's.
  static float region_depth(std::size_t n) { return static_cast<float>(n + 1) * 0x1p-24f; }

  // 20 bytes per pixel.
  GeometryBuffer(gpu::Device& device, int width, int height);

  // Where passes draw.
  gpu::ColorTarget texels() const;
  gpu::DepthTarget material_depth() const { return {.view = gpu::whole(depth_)}; }

  // Finds the pixels of each region: what is in front of the buffer's surfaces in `scene_depth` hides them. `begin` binds the
  // Region where all of them are.
  gpu::Pass material_depth_pass(const gpu::TextureRef& scene_depth,
                                const std::function<void(gpu::Encoder&)>& begin) const;

  // Binds the texels, as `geometry`.
  void bind(gpu::Encoder& encoder) const;
  gpu::View sampled() const { return gpu::whole(texels_); }

private:
  gpu::TextureRef texels_, depth_;
  gpu::SamplerRef nearest_;
  gpu::PipelineRef find_;
};

} // namespace gg::frame
