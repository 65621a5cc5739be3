#include "image/heat_map.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace gg::image {
namespace {

constexpr std::array<float, 3> paper{1.0f, 1.0f, 1.0f}, ink{0.1f, 0.1f, 0.1f};

// The legend, in pixels from its top.
constexpr int legend_width = 320, margin = 10;
constexpr int title_at = 8, bar_at = 28, bar_height = 14, tick = 4, numbers_at = 50;
constexpr int legend_height = 72;
constexpr int text_scale = 2; // of the font's 7-pixel letters

void fill(Image& image, int x0, int y0, int x1, int y1, const std::array<float, 3>& colour) {
  for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y)
    for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y, c) = colour[static_cast<std::size_t>(c)];
}

// The font has the printable ASCII characters and looks up nothing else safely.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

int text_width(std::string text) {
  return text_scale * stb_easy_font_width(text.data());
}

// stb's font is made of rectangles.
void draw_text(Image& image, int x, int y, std::string text) {
  struct Vertex {
    float x, y, z;
    unsigned char colour[4];
  };
  text = printable(text).substr(0, 200);
  std::array<Vertex, 4 * 4096> vertices; // a letter has at most 20 rectangles
  const int quads = stb_easy_font_print(0.0f, 0.0f, text.data(), nullptr, vertices.data(),
                                        static_cast<int>(sizeof vertices));
  for (std::size_t q = 0; q < static_cast<std::size_t>(quads); ++q) {
    const Vertex &from = vertices[4 * q], &to = vertices[4 * q + 2];
    const auto pixel = [](float v) { return text_scale * static_cast<int>(v); };
    fill(image, x + pixel(from.x), y + pixel(from.y), x + pixel(to.x), y + pixel(to.y), ink);
  }
}

std::string number(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", v);
  return text.data();
}

void draw_legend(Image& image, int top_row, double top, const std::string& title) {
  const int left = margin, right = image.width - margin;
  draw_text(image, left, top_row + title_at, title);
  for (int x = left; x < right; ++x)
    fill(image, x, top_row + bar_at, x + 1, top_row + bar_at + bar_height,
         heat_colour((x - left) / static_cast<double>(right - 1 - left)));
  constexpr int parts = 4;
  for (int i = 0; i <= parts; ++i) {
    const int x = left + (right - 1 - left) * i / parts;
    fill(image, x, top_row + bar_at + bar_height, x + 1, top_row + bar_at + bar_height + tick, ink);
    const std::string text = number(top * i / parts);
    const int width = text_width(text);
    draw_text(image, std::clamp(x - width / 2, left, right - width), top_row + numbers_at, text);
  }
}

} // namespace

std::array<float, 3> heat_colour(double t) {
  t = std::clamp(t, 0.0, 1.0);
  // A path through CIE LCh that stays within Rec. 709.
  const double lightness = 4.0 + 92.0 * t;
  const double chroma = 28.0 + 30.0 * std::sin(std::numbers::pi * t);
  const double hue = (295.0 + 165.0 * t) * std::numbers::pi / 180.0;
  const auto inverse = [](double f) { // of CIELAB's cube root and its straight piece
    constexpr double delta = 6.0 / 29.0;
    return f > delta ? f * f * f : 3.0 * delta * delta * (f - 4.0 / 29.0);
  };
  const double f = (lightness + 16.0) / 116.0;
  const double x = 0.95045592 * inverse(f + chroma * std::cos(hue) / 500.0);
  const double y = inverse(f);
  const double z = 1.08905775 * inverse(f - chroma * std::sin(hue) / 200.0);
  const auto encoded = [](double linear) { return static_cast<float>(srgb_from_linear(linear)); };
  return {encoded(3.24096994 * x - 1.53738318 * y - 0.49861076 * z),
          encoded(-0.96924364 * x + 1.87596750 * y + 0.04155506 * z),
          encoded(0.05563008 * x - 0.20397696 * y + 1.05697151 * z)};
}

Image heat_map(const Image& values, double top, const std::string& title) {
  Image image(std::max(values.width, legend_width), values.height + legend_height, 3);
  fill(image, 0, 0, image.width, image.height, paper);
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x)
      fill(image, x, y, x + 1, y + 1, heat_colour(static_cast<double>(values.at(x, y)) / top));
  draw_legend(image, values.height, top, title);
  return image;
}

double round_top(const Image& values) {
  std::vector<float> sorted = values.values;
  if (sorted.empty()) return 1.0;
  const std::size_t rank = (sorted.size() * 99 + 99) / 100 - 1;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(sorted.begin(), at, sorted.end());
  if (!(*at > 0.0f)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(static_cast<double>(*at))));
  for (const double step : {1.0, 2.0, 5.0})
    if (*at <= step * power) return step * power;
  return 10.0 * power;
}

} // namespace gg::image
