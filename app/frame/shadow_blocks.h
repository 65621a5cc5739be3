// Uniform data of shadow maps.
#pragma once

#include "needs/shadow_maps.h"
#include "uniforms/blocks.h"

#include <vector>

namespace gg::frame {

// To draw each view as a camera's.
std::vector<uniforms::FrameData> shadow_frames(const needs::ShadowMaps& maps);
// To find a place on them.
uniforms::ShadowsData shadows_block(const needs::ShadowMaps& maps);

} // namespace gg::frame
