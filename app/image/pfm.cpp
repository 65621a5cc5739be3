// Portable float maps: "PF" or "Pf", width and height, a scale whose sign is the byte order, then
// rows of floats from the bottom up (P. Debevec, pauldebevec.com/Research/HDR/PFM).
#include "core/error.h"
#include "image/formats.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace gg::image::formats {
namespace {

[[noreturn]] void fail(const std::string& name, std::size_t at, const std::string& what) {
  throw Error(ExitCode::input, name + ", byte " + std::to_string(at), what,
              "Download or write the file again.");
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

float float_from(std::uint32_t bits, bool little_endian) {
  if (little_endian != (std::endian::native == std::endian::little)) bits = __builtin_bswap32(bits);
  return std::bit_cast<float>(bits);
}

// The next blank-separated word; leaves `at` on the blank after it.
std::string_view word(std::string_view text, std::size_t& at, const std::string& name) {
  while (at < text.size() && is_blank(text[at]))
    ++at;
  const std::size_t begin = at;
  while (at < text.size() && !is_blank(text[at]))
    ++at;
  if (at >= text.size()) fail(name, begin, "ends in the middle of its header");
  return text.substr(begin, at - begin);
}

template <class Number>
Number number(std::string_view text, std::size_t& at, const std::string& name) {
  const std::string_view digits = word(text, at, name);
  Number value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size())
    fail(name, at - digits.size(),
         "should hold a number of the header, not \"" + std::string(digits.substr(0, 40)) + "\"");
  return value;
}

} // namespace

Image read_pfm(Bytes bytes, const std::string& name) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool grey = text[1] == 'f';
  std::size_t at = 2;
  const long long width = number<long long>(text, at, name);
  const long long height = number<long long>(text, at, name);
  const double scale = number<double>(text, at, name);
  check_size(name, width, height);
  if (!std::isfinite(scale) || scale == 0.0)
    fail(name, at, "should have a scale before this place whose sign says the byte order");
  if (std::abs(scale) != 1.0)
    note(name + ": the size of its scale is ignored; the values are taken as they are");
  if (text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n') ++at;
  ++at; // exactly one blank; what follows may look like one
  const std::size_t channels = grey ? 1 : 3;
  const std::size_t row_bytes = static_cast<std::size_t>(width) * channels * 4;
  const std::size_t needed = row_bytes * static_cast<std::size_t>(height);
  if (bytes.size() - at < needed)
    fail(name, bytes.size(),
         "ends too soon: its " + std::to_string(width) + " x " + std::to_string(height)
             + " pixels need " + std::to_string(at + needed) + " bytes");
  Image image(static_cast<int>(width), static_cast<int>(height), 3);
  for (int y = 0; y < image.height; ++y) {
    const std::byte* const row =
        bytes.data() + at + static_cast<std::size_t>(image.height - 1 - y) * row_bytes;
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        std::uint32_t bits = 0;
        const std::size_t value = static_cast<std::size_t>(x) * channels + (grey ? 0 : c);
        std::memcpy(&bits, row + value * 4, 4);
        image.at(x, y, static_cast<int>(c)) = float_from(bits, scale < 0.0);
      }
  }
  return image;
}

std::vector<std::byte> encode_pfm(const Image& image) {
  const bool little = std::endian::native == std::endian::little;
  const int channels = image.channels == 1 ? 1 : 3;
  const std::string header = std::string(channels == 1 ? "Pf\n" : "PF\n")
                             + std::to_string(image.width) + " " + std::to_string(image.height)
                             + (little ? "\n-1.0\n" : "\n1.0\n");
  std::vector<std::byte> out(header.size()
                             + image.index(0, image.height) / image.channels
                                   * static_cast<std::size_t>(channels) * 4);
  std::memcpy(out.data(), header.data(), header.size());
  std::byte* to = out.data() + header.size();
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x, to += channels * 4)
      std::memcpy(to, &image.values[image.index(x, y)], static_cast<std::size_t>(channels) * 4);
  return out;
}

} // namespace gg::image::formats
