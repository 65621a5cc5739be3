// What shaders are told of the neighbours of draws.
#pragma once

#include "needs/needs.h"
#include "uniforms/blocks.h"

#include <vector>

namespace gg::frame {

// One per draw of the needs that has neighbours, in their order.
std::vector<uniforms::NeighboursData> neighbour_blocks(const needs::Needs& needs);

} // namespace gg::frame
