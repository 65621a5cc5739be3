// Shadow maps of punctual lights: from where what casts is drawn, and where on the map what is lit finds itself.
#pragma once

#include "needs/draws.h"
#include "needs/shapes.h"
#include "needs/view.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace gg::needs {

// A view from a light, fitted to what casts and to what is lit.
struct ShadowView {
  glm::dmat4 clip_from_world{1.0}; // clip space of app/gpu/types.h, reversed depth
  glm::dvec3 eye{0.0};             // metres; not of a light from afar
  glm::dvec3 direction{0.0, 0.0, -1.0};
  bool from_afar = false; // a directional light: parallel rays
};

// The views of one light: one, or the six faces of a cube about a point, +X -X +Y -Y +Z -Z.
struct LightViews {
  std::size_t first = 0, count = 0;
  bool nothing_casts = false; // on what is seen: all of it is lit
};

struct ShadowMaps {
  int size = 0; // texels along each side of a map
  std::vector<ShadowView> views;
  std::vector<LightViews>
      of_light; // lights past the views' number have none: neighbours' shares shadow them
  std::vector<Draw> casters; // opaque surfaces and masks, in or out of the picture
  std::vector<Draw> filters; // glass and blended surfaces: they tint what passes
};

// As many as the block of shaders/interface/shadows.glsl holds.
inline constexpr std::size_t most_shadow_views = 12;

// Nothing where no light's shadow can fall on what is drawn: without lights, and where one convex thing stands alone. Balls of
// glass among the proxies (null: there are none) are lenses and left out (shaders/stages/neighbour_shadows.glsl). Sets
// Feature::lights of the draws.
ShadowMaps shadow_maps_of(const scene::Scene& scene, const View& view, Draws& draws, Shapes& shapes,
                          const Proxies* proxies);

} // namespace gg::needs
