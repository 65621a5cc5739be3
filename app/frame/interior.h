// Interior layers: the surfaces of solids one behind the other, in which the search for the exit of a
// refracted ray reads (shaders/refraction/interior_fetch.glsl).
#pragma once

#include "frame/draws.h"
#include "gpu/device.h"

#include <functional>
#include <span>
#include <vector>

namespace gg::frame {

class Interior {
public:
  // Room for `pairs` (1 or 2) pairs of a front and a back face per pixel: 32 bytes per pixel and pair.
  Interior(gpu::Device& device, int width, int height, int pairs);

  // Draws one face of `solids`, which must not hide each other on the screen: part 0 the nearest front, 1 the nearest back,
  // 2 and 3 the next of each. `begin` binds what all draws of the frame share.
  gpu::Pass pass(Draws& draws, const std::vector<const needs::Draw*>& solids, int part,
                 const std::function<void(gpu::Encoder&)>& begin) const;

  // Binds the layers, as `interior`.
  void bind(gpu::Encoder& encoder) const;
  gpu::View sampled() const { return gpu::whole(layers_); }

private:
  gpu::TextureRef layers_, depth_;
  gpu::SamplerRef nearest_;
};

} // namespace gg::frame
