// The picture behind a layer of glass, for its lookups: the screen pyramid (shaders/refraction/screen_pyramid.glsl) and depth.
#pragma once

#include "frame/draws.h"
#include "gpu/device.h"

#include <functional>
#include <vector>

namespace gg::frame {

class Backdrop {
public:
  struct Desc {
    int width, height, levels;
    bool depth;       // something looks for what it shows; with one level there is no blur
    bool glass_depth; // glass of one layer may hide parts of the next
  };
  Backdrop(gpu::Device& device, const Desc& desc);

  // Takes the frame as it is when the pass runs; its depth too, as what lookups meet or as the glass's.
  gpu::Pass copy_pass(const gpu::TextureRef& color, const gpu::TextureRef& depth,
                      const needs::Pass& takes) const;
  // Cuts out what `foreground` draws; `begin` binds what all draws of the frame share.
  gpu::Pass foreground_pass(const gpu::TextureRef& depth, Draws& draws,
                            const std::vector<const needs::Draw*>& foreground,
                            const std::function<void(gpu::Encoder&)>& begin) const;
  gpu::Pass level_pass(int level) const; // from the one before; level >= 1

  // Binds it for stages/surroundings.glsl and, of a layer, refractive_region.frag.
  void bind(gpu::Encoder& encoder, bool behind_glass = false) const;
  std::vector<gpu::View> sampled() const; // what bind() binds
  int last_level() const { return pyramid_->desc.levels - 1; }

private:
  gpu::View level(int l) const { return {pyramid_, l, 1, 0, 1}; }

  gpu::TextureRef pyramid_, depth_, glass_depth_; // null if there is none
  gpu::SamplerRef linear_, nearest_;
  gpu::PipelineRef copy_, copy_color_, halve_;
};

} // namespace gg::frame
