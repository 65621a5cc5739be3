// The picture behind a layer of glass, for its lookups: the screen pyramid (shaders/refraction/screen_pyramid.glsl) and depth.
#pragma once

#include "frame/uniform_array.h"
#include "gpu/device.h"

#include <vector>

namespace gg::frame {

class Backdrop {
public:
  Backdrop(gpu::Device& device, int width, int height);

  // Passes that fill it from the frame as it is when they run. `layers`: LayerData, of which element i is the layer's.
  void add_passes(std::vector<gpu::Pass>& passes, const gpu::TextureRef& color,
                  const gpu::TextureRef& depth, const UniformArray& layers, std::size_t i) const;

  // Binds it for stages/surroundings.glsl.
  void bind(gpu::Encoder& encoder) const;
  std::vector<gpu::View> sampled() const; // what bind() binds
  int last_level() const { return pyramid_->desc.levels - 1; }

private:
  gpu::TextureRef pyramid_, depth_;
  gpu::SamplerRef linear_, nearest_;
  gpu::PipelineRef copy_, halve_;
};

} // namespace gg::frame
