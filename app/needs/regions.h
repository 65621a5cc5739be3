// Deferred shading: which draws take it, and their regions.
#pragma once

#include "needs/draws.h"
#include "needs/layers.h"

#include <vector>

namespace gg::needs {

// Marks the opaque draws whose triangles are so small on the screen that shading deferred costs less (Draw::by_pixel).
void mark_fine(std::vector<Draw>& draws, const View& view);

// Whether shading takes from a draw's mesh what maps, colours of vertices or an alpha mask say, besides depth, normal and tangent.
bool keeps_maps(const Draw& draw);

// One region for the draws of each material that have the same neighbours, in their order: shading takes nothing else from a draw.
std::vector<Region> opaque_regions_of(const std::vector<const Draw*>& draws, const View& view);

} // namespace gg::needs
