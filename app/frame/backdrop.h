// The picture behind a layer of glass, for its lookups: the screen pyramid (shaders/refraction/screen_pyramid.glsl) and depth.
#pragma once

#include "frame/draws.h"
#include "gpu/device.h"

#include <functional>
#include <vector>

namespace gg::frame {

class Backdrop {
public:
  Backdrop(gpu::Device& device, int width, int height);

  // Adds the passes that fill it from the frame as it is when they run. What `foreground` draws is
  // cut out; `begin` binds what all draws of the frame share. Depth is taken once, while it is that
  // of opaque surfaces: rays pass other glass, and what they meet behind it shows its colour.
  void add_passes(std::vector<gpu::Pass>& passes, const gpu::TextureRef& color,
                  const gpu::TextureRef& depth, bool with_depth, Draws& draws,
                  const std::vector<const Draw*>& foreground,
                  const std::function<void(gpu::Encoder&)>& begin) const;

  // Binds it for stages/surroundings.glsl.
  void bind(gpu::Encoder& encoder) const;
  std::vector<gpu::View> sampled() const; // what bind() binds
  int last_level() const { return pyramid_->desc.levels - 1; }

private:
  gpu::TextureRef pyramid_, depth_;
  gpu::SamplerRef linear_, nearest_;
  gpu::PipelineRef copy_, copy_color_, halve_;
};

} // namespace gg::frame
