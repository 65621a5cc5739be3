// Deferred shading: which draws take it, and their regions.
#pragma once

#include "needs/draws.h"
#include "needs/layers.h"

#include <vector>

namespace gg::needs {

// Marks the opaque draws that shading deferred costs less (Draw::by_pixel): whose triangles are small on the screen, and those of
// which it can interpolate what neighbours add.
void mark_deferred(std::vector<Draw>& draws, const View& view);

inline bool interpolates_neighbours(const Draw& draw) {
  return value_of(draw.key, Feature::interpolated_neighbours) != 0;
}

// Whether shading takes from a draw's mesh what maps, colours of vertices or an alpha mask say, besides depth, normal and tangent.
bool keeps_maps(const Draw& draw);

// One region for the draws of each material that have the same neighbours, in their order: shading takes nothing else from a draw.
std::vector<Region> opaque_regions_of(const std::vector<const Draw*>& draws, const View& view);

} // namespace gg::needs
