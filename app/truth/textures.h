// Texture values as the raster's sharpest level gives them: bilinear between the texels' linear
// values, wrapped as the sampler says. No mip levels: the path tracer's many samples per pixel do
// the filtering.
#pragma once

#include "scene/scene.h"

namespace gg::truth {

enum class Encoding { linear, srgb };

class Textures {
public:
  explicit Textures(const scene::Scene& scene) : scene_(scene) {}

  // The value of a slot's texture at texture coordinates (before the slot's transform), each
  // component in [0, 1]; white where the file has no image.
  glm::dvec4 at(const scene::Slot& slot, glm::dvec2 uv, Encoding encoding) const;

private:
  const scene::Scene& scene_;
};

} // namespace gg::truth
