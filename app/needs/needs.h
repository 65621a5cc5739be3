// What a frame of a scene needs, decided in one place and carried out by app/frame: draws, layers, tables, images.
// Pure: no device, and the same answer for the same question.
#pragma once

#include "needs/draws.h"
#include "needs/layers.h"
#include "needs/memory.h"
#include "needs/proxies.h"
#include "needs/shadow_maps.h"
#include "needs/tables.h"
#include "needs/view.h"
#include "needs/walls.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace gg::needs {

// Lookups of the scene-colour pyramid or the environment by one pixel, at most.
struct Lookups {
  int reflected = 0;            // by a surface's own reflection
  int refracted = 0;            // through glass, where light first leaves it
  int internally_reflected = 0; // where it leaves after total internal reflections
  int residual = 0;             // residual energy after these
  int sum() const { return reflected + refracted + internally_reflected + residual; }
};
Lookups lookups_of(const Draw& draw, Method method);

// Points into itself and into the scene: it can be moved, not copied.
struct Needs {
  Needs() = default;
  Needs(Needs&&) = default;
  Needs& operator=(Needs&&) = default;

  const scene::Scene* scene = nullptr;
  View view;
  Draws draws;
  // Near to far: the depth test then spares hidden shading.
  std::vector<const Draw*> opaque;    // forward shaded
  std::vector<Region> opaque_regions; // of one material each, for deferred shading
  std::vector<LayerDraw> over_opaque; // blended surfaces with no glass behind them
  std::vector<Layer> layers;          // the farthest first, each with glass in it or behind it
  bool has_neighbours = false;        // light that leaves glass can meet other bodies
  std::shared_ptr<const Proxies>
      proxies; // of all bodies of the scene; none where no draw has neighbours
  std::shared_ptr<const Hollows>
      hollows; // their streams follow the scene's own; none where no draw has hollows
  ShadowMaps shadows;
  std::vector<Wall> walls; // planar proxies where the picture ends
  bool sky = false;
  scene::Bounds bounds; // of what is drawn, in the world: beyond it no ray meets anything

  std::vector<Table> tables;
  std::vector<Image> images;
  std::vector<scene::Index> streams, index_lists; // of the scene, that draws read
  Lookups lookups;

  // Some opaque surfaces are shaded after the opaque pass, and blended ones over them after that.
  bool shades_opaque_late() const { return !opaque_regions.empty(); }
  std::size_t triangle_count() const;                // per sample, each draw once
  const scene::Stream& stream(scene::Index i) const; // of `streams`
  std::vector<const Draw*> read() const;             // the draws, and those that shadow maps take
};

// Total reflections inside a solid that are followed.
inline constexpr int most_bounces = 4;

// `scene` must outlive the result. `shapes`, of that scene, spares working them out again for another view.
Needs needs_of(const scene::Scene& scene, const View& view, Shapes* shapes = nullptr);

} // namespace gg::needs
