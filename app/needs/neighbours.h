// The neighbours of a draw: proxies that it reflects and that occlude it.
#pragma once

#include "needs/draws.h"
#include "needs/proxies.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gg::needs {

// As many as a draw's block holds (shaders/interface/neighbours.glsl).
inline constexpr std::size_t most_neighbours = 8;
// Steradians that a proxy covers where the draw is nearest to it, below which it is left out: a 2,000th of what a point sees.
inline constexpr double least_solid_angle = 0.003;

// Gives every draw its neighbours (Draw::neighbours, indices into `proxies.all`) and the feature that says of what kinds they are:
// of the proxies of other bodies those that cover most of what the draw sees, nearer ones first, those of one body together.
void find_neighbours(Draws& draws, const scene::Scene& scene, const Proxies& proxies);

} // namespace gg::needs
