// A plot of curves over two axes.
#pragma once

#include "figures/canvas.h"

#include <optional>

namespace gg::figures {

struct Tick {
  double value = 0.0;
  std::string label; // empty: a grid line only
};

struct Axis {
  std::string label;
  double low = 0.0, high = 1.0;
  std::vector<Tick> ticks;
};
// Ticks from `low` to `high`, `step` apart, with so many decimals and the unit after each number.
std::vector<Tick> ticks(double low, double high, double step, int decimals,
                        const std::string& unit = {});

struct Curve {
  std::string label; // in the legend; empty: not there
  Color color = ink::black;
  Dash dash = Dash::solid;
  std::vector<Point> points; // in the axes' units; a NaN breaks the curve
  double width = 2.0;
};

// A vertical line at x with a word beside it, `height` of the way up the plot.
struct Mark {
  double x = 0.0;
  std::string label;
  Anchor anchor = Anchor::start; // start: to the right of the line
  double height = 0.95;
};

enum class Legend { none, top_left, top_right, bottom_left, bottom_right };

struct Plot {
  std::string title, note; // the note stands below the title, smaller
  Axis x, y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
  Legend legend = Legend::top_left;
};

// Draws the plot, its labels included, into the rectangle.
void draw(Canvas& canvas, const Plot& plot, Point corner, Point opposite);

} // namespace gg::figures
