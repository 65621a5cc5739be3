// Where a figure is drawn: one list of strokes, fills and texts, written as SVG and as PNG.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using cairo_t = struct _cairo;

namespace gg::figures {

struct Point {
  double x = 0.0, y = 0.0;
};
struct Color {
  double r = 0.0, g = 0.0, b = 0.0, a = 1.0;
};
enum class Dash { solid, dashed, dotted };
enum class Anchor { start, middle, end };
enum class Weight { normal, bold };

// Okabe and Ito's colours (2008), which the common kinds of colour blindness keep apart.
namespace ink {
inline constexpr Color black{0.13, 0.13, 0.13}, grey{0.42, 0.42, 0.42}, faint{0.86, 0.86, 0.86};
inline constexpr Color blue{0.0, 0.447, 0.698}, orange{0.902, 0.624, 0.0}, green{0.0, 0.62, 0.451},
    vermilion{0.835, 0.369, 0.0}, purple{0.8, 0.475, 0.655}, sky{0.337, 0.706, 0.914};
} // namespace ink

// Coordinates are points (1/72 inch), y down. Texts are drawn as outlines of DejaVu Sans, so that a
// figure looks the same wherever it is opened.
class Canvas {
public:
  explicit Canvas(cairo_t* context) : context_(context) {}

  void line(const std::vector<Point>& points, Color color, double width, Dash dash = Dash::solid);
  void polygon(const std::vector<Point>& points, Color fill);
  void arrow(Point from, Point to, Color color, double width);
  // `at` is the baseline's start, middle or end; turned counter-clockwise by `turn` radians.
  void text(Point at, const std::string& utf8, double size, Color color,
            Anchor anchor = Anchor::start, Weight weight = Weight::normal, double turn = 0.0);
  double text_width(const std::string& utf8, double size, Weight weight = Weight::normal);
  // Draws only inside the rectangle until the function returns.
  void clipped(Point corner, Point opposite, const std::function<void()>& draw);

private:
  void trace(const std::vector<Point>& points);
  void pen(Color color, double width, Dash dash);
  void font(double size, Weight weight);
  cairo_t* context_;
};

// Writes DIR/name.svg and DIR/name.png (two pixels to a point, white ground). The same drawing
// gives the same bytes. Throws Error(output).
void write_figure(const std::filesystem::path& directory, const std::string& name, double width,
                  double height, const std::function<void(Canvas&)>& draw);

} // namespace gg::figures
