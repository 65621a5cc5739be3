#include "figures/canvas.h"

#include "core/error.h"
#include "core/files.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <span>

namespace gg::figures {
namespace {

using SurfaceOwner = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using ContextOwner = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double pixels_per_point = 2.0;

// The same line with fewer points: a point goes if the line from the last one kept to the next
// passes within `tolerance` points of all that lie between.
std::vector<Point> simplified(const std::vector<Point>& line) {
  constexpr double tolerance = 0.03; // less than a tenth of a pixel in the PNG
  if (line.size() < 3) return line;
  std::vector<Point> kept{line.front()};
  std::size_t last = 0;
  for (std::size_t next = 2; next < line.size(); ++next) {
    const Point a = line[last], b = line[next];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    bool close = length > 0.0;
    for (std::size_t between = last + 1; close && between < next; ++between) {
      const Point c = line[between];
      close = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) <= tolerance * length;
    }
    if (close) continue;
    last = next - 1;
    kept.push_back(line[last]);
  }
  kept.push_back(line.back());
  return kept;
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void expect(cairo_status_t status, const std::filesystem::path& path) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ExitCode::output, path,
                std::string("cannot be drawn: ") + cairo_status_to_string(status),
                "Check the memory and the fonts of this machine.");
}

void paint(cairo_surface_t* surface, double scale, const std::filesystem::path& path,
           const std::function<void(Canvas&)>& draw) {
  const ContextOwner context(cairo_create(surface), cairo_destroy);
  cairo_scale(context.get(), scale, scale);
  cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
  cairo_paint(context.get());
  // Outlines as designed, placed as designed: no grid fitting that would differ between the two
  // files.
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> fonts(
      cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_antialias(fonts.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(fonts.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(fonts.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context.get(), fonts.get());
  Canvas canvas(context.get());
  draw(canvas);
  expect(cairo_status(context.get()), path);
}

// Cairo numbers its surfaces through the life of a process and writes the number as the id of the
// drawing's group, to which nothing refers. Without it the bytes do not depend on what was drawn
// before.
std::string without_surface_number(std::string svg) {
  const std::string_view opening = "<g id=\"surface";
  const std::size_t start = svg.find(opening);
  if (start == std::string::npos) return svg;
  const std::size_t number = start + opening.size();
  return svg.erase(number, svg.find('"', number) - number);
}

void save(const std::filesystem::path& path, const std::string& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

} // namespace

void Canvas::trace(const std::vector<Point>& line_or_outline) {
  const std::vector<Point> points = simplified(line_or_outline);
  for (std::size_t p = 0; p < points.size(); ++p)
    (p == 0 ? cairo_move_to : cairo_line_to)(context_, points[p].x, points[p].y);
}

void Canvas::pen(Color color, double width, Dash dash) {
  cairo_set_source_rgba(context_, color.r, color.g, color.b, color.a);
  cairo_set_line_width(context_, width);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context_, dash == Dash::dotted ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  const double dashes[] = {4.0 * width, 2.2 * width}, dots[] = {0.01, 2.2 * width};
  if (dash == Dash::solid)
    cairo_set_dash(context_, nullptr, 0, 0.0);
  else
    cairo_set_dash(context_, dash == Dash::dashed ? dashes : dots, 2, 0.0);
}

void Canvas::font(double size, Weight weight) {
  cairo_select_font_face(context_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         weight == Weight::bold ? CAIRO_FONT_WEIGHT_BOLD
                                                : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, size);
}

void Canvas::line(const std::vector<Point>& points, Color color, double width, Dash dash) {
  pen(color, width, dash);
  trace(points);
  cairo_stroke(context_);
}

void Canvas::polygon(const std::vector<Point>& points, Color fill) {
  cairo_set_source_rgba(context_, fill.r, fill.g, fill.b, fill.a);
  trace(points);
  cairo_close_path(context_);
  cairo_fill(context_);
}

void Canvas::arrow(Point from, Point to, Color color, double width) {
  const double angle = std::atan2(to.y - from.y, to.x - from.x);
  const double size = 4.5 * width, spread = 0.42;
  const auto barb = [&](double side) {
    return Point{to.x - size * std::cos(angle + side * spread),
                 to.y - size * std::sin(angle + side * spread)};
  };
  const Point neck{to.x - 0.8 * size * std::cos(angle), to.y - 0.8 * size * std::sin(angle)};
  line({from, neck}, color, width);
  polygon({to, barb(1.0), barb(-1.0)}, color);
}

double Canvas::text_width(const std::string& utf8, double size, Weight weight) {
  font(size, weight);
  cairo_text_extents_t extents;
  cairo_text_extents(context_, utf8.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(Point at, const std::string& utf8, double size, Color color, Anchor anchor,
                  Weight weight, double turn) {
  const double width = text_width(utf8, size, weight);
  const double shift = anchor == Anchor::start ? 0.0 : anchor == Anchor::middle ? 0.5 : 1.0;
  cairo_save(context_);
  cairo_translate(context_, at.x, at.y);
  cairo_rotate(context_, -turn);
  cairo_move_to(context_, -shift * width, 0.0);
  cairo_set_source_rgba(context_, color.r, color.g, color.b, color.a);
  cairo_show_text(context_, utf8.c_str());
  cairo_restore(context_);
}

void Canvas::clipped(Point corner, Point opposite, const std::function<void()>& draw) {
  cairo_save(context_);
  cairo_rectangle(context_, corner.x, corner.y, opposite.x - corner.x, opposite.y - corner.y);
  cairo_clip(context_);
  draw();
  cairo_restore(context_);
}

void write_figure(const std::filesystem::path& directory, const std::string& name, double width,
                  double height, const std::function<void(Canvas&)>& draw) {
  const auto svg_path = directory / (name + ".svg"), png_path = directory / (name + ".png");
  std::string bytes;
  {
    const SurfaceOwner svg(cairo_svg_surface_create_for_stream(append, &bytes, width, height),
                           cairo_surface_destroy);
    paint(svg.get(), 1.0, svg_path, draw);
    cairo_surface_finish(svg.get());
    expect(cairo_surface_status(svg.get()), svg_path);
  }
  save(svg_path, without_surface_number(bytes));

  bytes.clear();
  const SurfaceOwner png(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                    static_cast<int>(width * pixels_per_point),
                                                    static_cast<int>(height * pixels_per_point)),
                         cairo_surface_destroy);
  paint(png.get(), pixels_per_point, png_path, draw);
  expect(cairo_surface_write_to_png_stream(png.get(), append, &bytes), png_path);
  save(png_path, bytes);
}

} // namespace gg::figures
