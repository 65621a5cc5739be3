// Layers of glass and blended surfaces, far to near; draws that do not overlap on the screen share one.
#pragma once

#include "needs/draws.h"

#include <glm/glm.hpp>

#include <vector>

namespace gg::needs {

// Which faces of a draw belong to a layer.
enum class Faces { as_material, front, back };

struct LayerDraw {
  const Draw* draw;
  Faces faces;
};

// A rectangle on the screen, clip coordinates -1..1 divided by w; everything if it reaches behind
// the camera.
struct ScreenBox {
  glm::dvec2 low{-1.0}, high{1.0};
  double nearest_depth = 1.0, farthest_depth = 0.0; // device depth, 1 near
  bool overlaps(const ScreenBox& other) const;
};
ScreenBox screen_box(const scene::Bounds& bounds, const glm::dmat4& clip_from_world);
void grow(ScreenBox& box, const ScreenBox& other); // to hold the other too

// What is shaded deferred, by region: draws of one material, of glass those of one instance (a solid).
struct Region {
  std::vector<const Draw*> draws;
  ScreenBox box;
};

// Surfaces that share one copy of the scene behind them.
struct Layer {
  std::vector<LayerDraw> refractive, blended;
  std::vector<Region> regions;
  std::vector<const Draw*>
      foreground;                  // opaque draws that stand wholly in front of it and overlap it
  std::vector<const Draw*> solids; // refractive draws inside which rays are followed
  int interior_pairs = 0;          // the most that one of them wants
  bool shows_behind() const {
    return !refractive.empty() || !regions.empty();
  }                         // a copy of the scene behind it
  bool blurs = false;       // and refracts it: needs its pyramid and depth
  bool interleaves = false; // a deferred region may be partly behind glass of an earlier layer
};

// Refractive and blended draws by layer, the farthest first. The parts of a solid (one instance, one
// body) stay together. A thin wall that shows both sides is two things: its far side, then its
// near one; unless it is planar. `most` > 0 layers at most: what would need more goes into the last, each part in its
// order. Pure.
std::vector<Layer> layers_of(const scene::Scene& scene, const Draws& draws,
                             const glm::dmat4& clip_from_world, std::size_t most);

} // namespace gg::needs
