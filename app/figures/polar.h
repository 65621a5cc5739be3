// A polar picture of what one interface does with light from one direction: the plane of incidence,
// the normal up.
#pragma once

#include "figures/canvas.h"

#include <optional>

namespace gg::figures {

// Directions are angles in radians from the normal of their own side, positive away from the light.
struct Lobe {
  std::vector<Point> points;   // x: angle in -pi/2..pi/2, y: value
  std::optional<double> ideal; // where a smooth interface would send the light
  std::optional<double> mean;  // where this one sends it on average
};

struct PolarPanel {
  std::string title;
  double incidence = 0.0; // radians
  Lobe reflected, transmitted;
  bool dense_above = false; // the light is inside the glass
};

// How the parts are told apart, for the legend.
struct PolarStyle {
  Color reflected = ink::vermilion, transmitted = ink::blue;
};

// Each lobe is scaled by its own largest value, which is written beside it.
void draw(Canvas& canvas, const PolarPanel& panel, Point corner, Point opposite);
void draw_polar_legend(Canvas& canvas, Point at);

} // namespace gg::figures
