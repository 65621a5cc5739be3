#include "report/webp.h"

#include "core/error.h"
#include "image/heat_map.h"

#include <webp/encode.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gg::report {

std::vector<std::byte> webp_of(const image::Image& display) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * static_cast<std::size_t>(display.width)
              * static_cast<std::size_t>(display.height));
  for (int y = 0; y < display.height; ++y)
    for (int x = 0; x < display.width; ++x)
      for (int c = 0; c < 3; ++c)
        rgb.push_back(static_cast<std::uint8_t>(
            std::lround(255.0f * std::clamp(display.at(x, y, c), 0.0f, 1.0f))));
  std::uint8_t* out = nullptr;
  const std::size_t bytes =
      WebPEncodeLosslessRGB(rgb.data(), display.width, display.height, 3 * display.width, &out);
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> owner(out, WebPFree);
  if (bytes == 0)
    throw Error(ExitCode::output, "the report's pictures",
                std::to_string(display.width) + " x " + std::to_string(display.height)
                    + " pixels cannot be encoded as WebP",
                "WebP goes up to 16383 pixels a side; use a smaller --size.");
  const auto* const first = reinterpret_cast<const std::byte*>(out);
  return {first, first + bytes};
}

image::Image coloured(const image::Image& map) {
  image::Image colours(map.width, map.height, 3);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const auto rgb = image::heat_colour(static_cast<double>(map.values[i]));
    std::copy(rgb.begin(), rgb.end(), colours.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return colours;
}

std::string data_uri(const std::vector<std::byte>& webp) {
  // RFC 4648.
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = "data:image/webp;base64,";
  uri.reserve(uri.size() + (webp.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < webp.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, webp.size() - i);
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < left ? static_cast<unsigned>(webp[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      uri += k <= left ? digits[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return uri;
}

} // namespace gg::report
