// What a draw covers of the screen, closer than a rectangle: its extent along eight directions, 22.5 degrees apart. Of a disc
// that is 1 % of its radius too much, of a rectangle's corners half.
#pragma once

#include "needs/draws.h"

#include <glm/glm.hpp>

#include <array>
#include <limits>

namespace gg::needs {

struct Outline {
  static constexpr std::size_t directions = 8;
  // Along direction k, of places (x, y) in clip coordinates divided by w. Nothing yet.
  std::array<double, directions> low, high;
  Outline();
  void include(const glm::dvec2& place);
  void include_everything();
  void include(const Outline& other);
  // False only where one of the eight directions separates the two.
  bool overlaps(const Outline& other) const;
};

// Of the draw's vertices; everything if one of them is not in front of the near plane.
Outline outline_of(const scene::Scene& scene, const Draw& draw, const scene::Instance& instance,
                   const glm::dmat4& clip_from_world);

} // namespace gg::needs
