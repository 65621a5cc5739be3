// Pipelines that several passes share.
#pragma once

#include "frame/context.h"

#include <cstdint>
#include <vector>

namespace gg::frame {

// Surfaces that cover what is behind them in part.
inline DrawPass blended_pass() {
  return {.label = "blended",
          .fragment = "opaque.frag",
          .colors = {color_format},
          .depth_write = false,
          .blend = gpu::Blend::over};
}

// Faces into the depth, where they hide what is behind them, and no colour.
inline DrawPass hiding_pass(std::string label) {
  return {.label = std::move(label),
          .fragment = "foreground.frag",
          .colors = {color_format},
          .blend = gpu::Blend::over};
}

// Constants of the glass stages that depend on the whole frame, not on a material (app/needs/features.h has those).
inline std::vector<gpu::Constant> glass_constants(const needs::Needs& needs) {
  constexpr std::uint32_t has_neighbours = 51, most_bounces = 52, has_walls = 54;
  return {gpu::constant(has_neighbours, needs.has_neighbours),
          gpu::constant(most_bounces, needs::most_bounces),
          gpu::constant(has_walls, !needs.walls.empty())};
}

} // namespace gg::frame
