// Uniform data of the neighbours of draws.
#pragma once

#include "needs/needs.h"
#include "uniforms/blocks.h"

#include <map>
#include <utility>
#include <vector>

namespace gg::frame {

// Mean colours of a scene's images, linear, by index and whether they are sRGB.
using ImageMeans = std::map<std::pair<scene::Index, bool>, glm::vec3>;

// One per draw of the needs that has neighbours, in their order. `means` holds what earlier calls for the same scene took of
// its images, and is added to.
std::vector<uniforms::NeighboursData> neighbour_blocks(const needs::Needs& needs,
                                                       ImageMeans& means);

} // namespace gg::frame
