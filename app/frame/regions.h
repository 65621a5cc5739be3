// The uniform blocks of what is shaded by region (shaders/interface/region.glsl): the opaque ones, all of these as one, then
// those of each layer.
#pragma once

#include "gpu/device.h"
#include "needs/needs.h"
#include "uniforms/blocks.h"

#include <cstddef>
#include <vector>

namespace gg::frame {

inline constexpr int glass_step = 4;

std::vector<uniforms::RegionData> region_blocks(const needs::Needs& needs);

// Where they are in that list.
inline std::size_t opaque_region(std::size_t region) {
  return region;
}
inline std::size_t all_opaque_regions(const needs::Needs& needs) {
  return needs.opaque_regions.size();
}
// At every pixel, or at one in glass_step x glass_step.
std::size_t layer_region(const needs::Needs& needs, std::size_t layer, std::size_t region,
                         bool low_rate = false);

} // namespace gg::frame
