#include "figures/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::figures {
namespace {

constexpr double title_size = 13.0, label_size = 11.0, tick_size = 10.0;
constexpr Color box_fill{1.0, 1.0, 1.0, 0.88};

// The frame inside the rectangle and the way from the axes' units to points.
struct Frame {
  double left, top, right, bottom;
  const Plot& plot;

  Point at(Point p) const {
    return {left + (p.x - plot.x.low) / (plot.x.high - plot.x.low) * (right - left),
            bottom - (p.y - plot.y.low) / (plot.y.high - plot.y.low) * (bottom - top)};
  }
};

void draw_axes(Canvas& canvas, const Frame& f) {
  for (const Tick& tick : f.plot.x.ticks) {
    const double x = f.at({tick.value, 0.0}).x;
    canvas.line({{x, f.top}, {x, f.bottom}}, ink::faint, 0.7);
    canvas.line({{x, f.bottom}, {x, f.bottom + 4.0}}, ink::grey, 0.8);
    canvas.text({x, f.bottom + 16.0}, tick.label, tick_size, ink::black, Anchor::middle);
  }
  for (const Tick& tick : f.plot.y.ticks) {
    const double y = f.at({0.0, tick.value}).y;
    canvas.line({{f.left, y}, {f.right, y}}, ink::faint, 0.7);
    canvas.line({{f.left - 4.0, y}, {f.left, y}}, ink::grey, 0.8);
    canvas.text({f.left - 7.0, y + 3.5}, tick.label, tick_size, ink::black, Anchor::end);
  }
  canvas.line({{f.left, f.top}, {f.left, f.bottom}, {f.right, f.bottom}}, ink::grey, 1.0);
  canvas.text({0.5 * (f.left + f.right), f.bottom + 34.0}, f.plot.x.label, label_size, ink::black,
              Anchor::middle);
  canvas.text({f.left - 40.0, 0.5 * (f.top + f.bottom)}, f.plot.y.label, label_size, ink::black,
              Anchor::middle, Weight::normal, 0.5 * std::numbers::pi);
}

void draw_curve(Canvas& canvas, const Frame& f, const Curve& curve) {
  std::vector<Point> piece;
  const auto finish = [&] {
    if (piece.size() > 1) canvas.line(piece, curve.color, curve.width, curve.dash);
    piece.clear();
  };
  for (const Point& p : curve.points) {
    if (std::isnan(p.y))
      finish();
    else
      piece.push_back(f.at(p));
  }
  finish();
}

void draw_mark(Canvas& canvas, const Frame& f, const Mark& mark) {
  const double x = f.at({mark.x, 0.0}).x;
  canvas.line({{x, f.top}, {x, f.bottom}}, ink::grey, 1.0, Dash::dashed);
  const double gap = mark.anchor == Anchor::start ? 5.0 : -5.0;
  canvas.text({x + gap, f.bottom - mark.height * (f.bottom - f.top)}, mark.label, tick_size,
              ink::grey, mark.anchor);
}

void draw_legend(Canvas& canvas, const Frame& f) {
  double width = 0.0, rows = 0.0;
  for (const Curve& curve : f.plot.curves)
    if (!curve.label.empty()) {
      width = std::max(width, canvas.text_width(curve.label, tick_size));
      rows += 1.0;
    }
  if (rows == 0.0) return;
  constexpr double row = 16.0, swatch = 26.0, pad = 7.0;
  const double box_width = width + swatch + 3.0 * pad, box_height = rows * row + pad;
  const bool right = f.plot.legend == Legend::top_right || f.plot.legend == Legend::bottom_right;
  const bool low = f.plot.legend == Legend::bottom_left || f.plot.legend == Legend::bottom_right;
  const double x = right ? f.right - box_width - 6.0 : f.left + 10.0;
  const double y = low ? f.bottom - box_height - 10.0 : f.top + 8.0;
  canvas.polygon({{x, y}, {x + box_width, y}, {x + box_width, y + box_height}, {x, y + box_height}},
                 box_fill);
  double line = y + 0.5 * pad + 0.5 * row;
  for (const Curve& curve : f.plot.curves) {
    if (curve.label.empty()) continue;
    canvas.line({{x + pad, line}, {x + pad + swatch, line}}, curve.color, curve.width, curve.dash);
    canvas.text({x + 2.0 * pad + swatch, line + 3.6}, curve.label, tick_size, ink::black);
    line += row;
  }
}

} // namespace

std::vector<Tick> ticks(double low, double high, double step, int decimals,
                        const std::string& unit) {
  std::vector<Tick> all;
  const int count = static_cast<int>(std::lround((high - low) / step));
  for (int t = 0; t <= count; ++t) {
    const double value = low + t * step;
    all.push_back({value, fmt::format("{:.{}f}{}", value, decimals, unit)});
  }
  return all;
}

void draw(Canvas& canvas, const Plot& plot, Point corner, Point opposite) {
  const double heading = (plot.title.empty() ? 0.0 : 20.0) + (plot.note.empty() ? 0.0 : 15.0);
  const Frame f{corner.x + 56.0, corner.y + 12.0 + heading, opposite.x - 18.0, opposite.y - 44.0,
                plot};
  canvas.text({f.left, corner.y + 18.0}, plot.title, title_size, ink::black, Anchor::start,
              Weight::bold);
  canvas.text({f.left, corner.y + 34.0}, plot.note, tick_size, ink::grey);
  draw_axes(canvas, f);
  canvas.clipped({f.left, f.top - 1.5}, {f.right + 1.5, f.bottom + 1.5}, [&] {
    for (const Mark& mark : plot.marks)
      draw_mark(canvas, f, mark);
    for (const Curve& curve : plot.curves)
      draw_curve(canvas, f, curve);
  });
  if (plot.legend != Legend::none) draw_legend(canvas, f);
}

} // namespace gg::figures
