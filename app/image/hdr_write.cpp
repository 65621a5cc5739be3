// Writing Radiance pictures: the newer run-length encoding where the format allows it, else flat.
#include "image/formats.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gg::image::formats {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// The largest float that RGBE holds: 255 * 2^(255 - 136).
constexpr float largest = 255.0f * 0x1p119f;

// Rounded to the nearest step of the largest channel, so that the mean of many pixels is kept (the
// usual truncation darkens by half a step, 0.3 %).
Rgbe encode(std::array<float, 3> colour) {
  for (float& value : colour)
    value = std::clamp(value, 0.0f, largest);
  const float brightest = std::max({colour[0], colour[1], colour[2]});
  int exponent = 0; // brightest = m * 2^exponent, m in [1/2, 1): a step is 2^(exponent - 8)
  if (std::frexp(brightest, &exponent) == 0.0f) return {};
  // Rounding up to 256 steps is the next exponent's 128.
  if (std::round(std::ldexp(brightest, 8 - exponent)) > 255.0f) ++exponent;
  if (exponent + 128 < 1) return {}; // below the smallest step
  Rgbe pixel{};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::round(std::ldexp(colour[c], 8 - exponent)));
  pixel[3] = static_cast<std::uint8_t>(exponent + 128);
  return pixel;
}

void append(std::vector<std::byte>& out, std::size_t value) {
  out.push_back(static_cast<std::byte>(value));
}

// One channel of a scan line: runs of 4 to 127 equal values, literals of up to 128.
void append_plane(std::vector<std::byte>& out, const std::vector<Rgbe>& line, std::size_t channel) {
  const auto run_at = [&](std::size_t x) {
    std::size_t end = x + 1;
    while (end < line.size() && end - x < 127 && line[end][channel] == line[x][channel])
      ++end;
    return end - x;
  };
  constexpr std::size_t shortest_run = 4;
  for (std::size_t x = 0; x < line.size();) {
    if (const std::size_t run = run_at(x); run >= shortest_run) {
      append(out, 128 + run);
      append(out, line[x][channel]);
      x += run;
      continue;
    }
    std::size_t end = x + 1;
    while (end < line.size() && end - x < 128 && run_at(end) < shortest_run)
      ++end;
    append(out, end - x);
    for (; x < end; ++x)
      append(out, line[x][channel]);
  }
}

} // namespace

std::vector<std::byte> encode_hdr(const Image& image) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y "
                             + std::to_string(image.height) + " +X " + std::to_string(image.width)
                             + "\n";
  std::vector<std::byte> out;
  for (const char c : header)
    append(out, static_cast<unsigned char>(c));
  const std::size_t width = static_cast<std::size_t>(image.width);
  std::vector<Rgbe> line(width);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const float* const v = &image.values[image.index(x, y)];
      line[static_cast<std::size_t>(x)] =
          image.channels == 1 ? encode({v[0], v[0], v[0]}) : encode({v[0], v[1], v[2]});
    }
    if (width >= 8 && width <= 32767) {
      for (const std::size_t value : {std::size_t{2}, std::size_t{2}, width >> 8, width & 255})
        append(out, value);
      for (std::size_t channel = 0; channel < 4; ++channel)
        append_plane(out, line, channel);
    } else {
      // A pixel (1, 1, 1, e) would read as a run, but the brightest channel is always 128 or more.
      for (const Rgbe& pixel : line)
        for (const std::uint8_t value : pixel)
          append(out, value);
    }
  }
  return out;
}

} // namespace gg::image::formats
