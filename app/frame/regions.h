// The uniform blocks of what is shaded by region (shaders/interface/region.glsl): the opaque ones, then those of each layer.
#pragma once

#include "gpu/device.h"
#include "needs/needs.h"
#include "uniforms/blocks.h"

#include <cstddef>
#include <vector>

namespace gg::frame {

inline constexpr int glass_step = 4;

std::vector<uniforms::RegionData> region_blocks(const needs::Needs& needs);

// Corners of cells along so many pixels (shaders/stages/neighbour_light.glsl).
inline int corners_of(int pixels) {
  return (pixels + uniforms::CELL_STEP - 1) / uniforms::CELL_STEP + 1;
}

// Where they are in that list: at pixels that are shaded alone, between corners of cells, and at these.
inline std::size_t opaque_region(std::size_t region) {
  return region;
}
inline std::size_t all_opaque_regions(const needs::Needs& needs) {
  return needs.opaque_regions.size();
}
inline std::size_t interpolated_region(const needs::Needs& needs, std::size_t region) {
  return needs.opaque_regions.size() + 1 + region;
}
inline std::size_t opaque_corners(const needs::Needs& needs, std::size_t region) {
  return 2 * needs.opaque_regions.size() + 1 + region;
}
inline std::size_t all_opaque_corners(const needs::Needs& needs) {
  return 3 * needs.opaque_regions.size() + 1;
}
// At every pixel, or at one in glass_step x glass_step.
std::size_t layer_region(const needs::Needs& needs, std::size_t layer, std::size_t region,
                         bool low_rate = false);

} // namespace gg::frame
