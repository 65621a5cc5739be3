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

  // Adds the passes that draw the faces of `solids`, which must not hide each other on the screen:
  // nearest front, nearest back, and with `pairs` 2 the next of each. `begin` binds what all draws of
  // the frame share.
  void add_passes(std::vector<gpu::Pass>& passes, Draws& draws, std::vector<const Draw*> solids,
                  int pairs, const std::function<void(gpu::Encoder&)>& begin);

  // Binds the layers, as `interior`.
  void bind(gpu::Encoder& encoder) const;
  gpu::View sampled() const { return gpu::whole(layers_); }

private:
  gpu::TextureRef layers_, depth_;
  gpu::SamplerRef nearest_;
};

} // namespace gg::frame
