#include "figures/polar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::figures {
namespace {

using std::numbers::pi;
constexpr Color glass{0.337, 0.706, 0.914, 0.16};
constexpr PolarStyle style;

struct Half {
  Point centre;
  double radius;
  double up; // 1 for the side of the light, -1 for the other

  Point at(double angle, double r) const {
    return {centre.x + radius * r * std::sin(angle), centre.y - up * radius * r * std::cos(angle)};
  }
};

std::vector<Point> arc(const Half& half, double r) {
  std::vector<Point> points;
  for (int step = -90; step <= 90; step += 2)
    points.push_back(half.at(step * pi / 180.0, r));
  return points;
}

Color veil(Color color) {
  return {color.r, color.g, color.b, 0.30};
}

void draw_lobe(Canvas& canvas, const Half& half, const Lobe& lobe, Color color,
               const std::string& name) {
  double largest = 0.0;
  for (const Point& p : lobe.points)
    largest = std::max(largest, p.y);
  const std::string label =
      largest > 0.0 ? fmt::format("{} ≤ {:.3g} / sr", name, largest) : fmt::format("{} = 0", name);
  canvas.text(
      {half.centre.x, half.centre.y - half.up * (half.radius + 27.0) + (half.up < 0.0 ? 8.0 : 0.0)},
      label, 9.5, color, Anchor::middle);
  if (largest > 0.0) {
    std::vector<Point> outline{half.centre};
    for (const Point& p : lobe.points)
      outline.push_back(half.at(p.x, p.y / largest));
    canvas.polygon(outline, veil(color));
    outline.push_back(half.centre);
    canvas.line(outline, color, 1.5);
  }
  if (lobe.ideal)
    canvas.line({half.centre, half.at(*lobe.ideal, 1.0)}, ink::black, 1.3, Dash::dashed);
  if (lobe.mean) canvas.arrow(half.centre, half.at(*lobe.mean, 1.0), color, 1.8);
}

void draw_grid(Canvas& canvas, const Half& half) {
  for (const double r : {0.5, 1.0})
    canvas.line(arc(half, r), ink::faint, 0.8);
  for (int degrees = -60; degrees <= 60; degrees += 30) {
    const double angle = degrees * pi / 180.0;
    canvas.line({half.centre, half.at(angle, 1.0)}, ink::faint, 0.6);
    const Point end = half.at(angle, 1.11);
    canvas.text({end.x, end.y + 3.0}, fmt::format("{}°", std::abs(degrees)), 8.0, ink::grey,
                Anchor::middle);
  }
}

} // namespace

void draw(Canvas& canvas, const PolarPanel& panel, Point corner, Point opposite) {
  const Point centre{0.5 * (corner.x + opposite.x), 0.5 * (corner.y + opposite.y) + 10.0};
  const double radius =
      std::min(0.5 * (opposite.x - corner.x) - 12.0, 0.5 * (opposite.y - corner.y) - 46.0);
  const Half above{centre, radius, 1.0}, below{centre, radius, -1.0};

  canvas.polygon(arc(panel.dense_above ? above : below, 1.0), glass);
  draw_grid(canvas, above);
  draw_grid(canvas, below);
  canvas.line({{centre.x - radius, centre.y}, {centre.x + radius, centre.y}}, ink::grey, 1.2);
  canvas.text({centre.x, corner.y + 12.0}, panel.title, 12.0, ink::black, Anchor::middle,
              Weight::bold);
  draw_lobe(canvas, above, panel.reflected, style.reflected, "f_r |o·n|");
  draw_lobe(canvas, below, panel.transmitted, style.transmitted, "f_t |o·n|");
  canvas.arrow(above.at(-panel.incidence, 1.0), above.at(-panel.incidence, 0.06), ink::black, 1.8);
}

void draw_polar_legend(Canvas& canvas, Point at) {
  double x = at.x;
  const auto entry = [&](const std::string& text, const auto& swatch) {
    swatch(Point{x, at.y - 3.5}, Point{x + 26.0, at.y - 3.5});
    canvas.text({x + 32.0, at.y}, text, 10.0, ink::black);
    x += 32.0 + canvas.text_width(text, 10.0) + 22.0;
  };
  entry("light", [&](Point a, Point b) { canvas.arrow(a, b, ink::black, 1.8); });
  entry("mirror and Snell directions", [&](Point a, Point b) {
    canvas.line({a, b}, ink::black, 1.3, Dash::dashed);
  });
  entry("mean reflected direction",
        [&](Point a, Point b) { canvas.arrow(a, b, style.reflected, 1.8); });
  entry("mean transmitted direction",
        [&](Point a, Point b) { canvas.arrow(a, b, style.transmitted, 1.8); });
  entry("glass", [&](Point a, Point b) {
    canvas.polygon({{a.x, a.y - 5.0}, {b.x, b.y - 5.0}, {b.x, b.y + 5.0}, {a.x, a.y + 5.0}}, glass);
  });
}

} // namespace gg::figures
