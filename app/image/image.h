// Pictures in memory and on disk. Linear floating point throughout; the display transform is in
// shaders/color.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gg::image {

// Row 0 is the top; pixels are interleaved: value(x, y, c) = values[(y * width + x) * channels +
// c].
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<float> values;

  Image() = default;
  Image(int w, int h, int c) : width(w), height(h), channels(c) {
    values.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)
                  * static_cast<std::size_t>(c));
  }
  std::size_t index(int x, int y, int c = 0) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
            + static_cast<std::size_t>(x))
               * static_cast<std::size_t>(channels)
           + static_cast<std::size_t>(c);
  }
  float& at(int x, int y, int c = 0) { return values[index(x, y, c)]; }
  float at(int x, int y, int c = 0) const { return values[index(x, y, c)]; }
};

// 8-bit RGBA as decoded from PNG, JPEG or WebP: encoded values, not linear. Row 0 is the top.
struct Image8 {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba; // 4 * width * height
};

// Linear pictures: .hdr (Radiance RGBE, old and new run-length encoding), .exr, .pfm, and .png
// (8-bit sRGB, made linear). `channels` of the result is 3 or 4. Throws Error(input) naming the
// file and what is wrong with it.
Image read(const std::filesystem::path& path);

// Writes linear values by extension: .exr (float), .hdr (RGBE: 1 % steps), .pfm; and .png: the
// values, clamped to 0..1, are taken as display-encoded already and quantised to 8 bits with
// rounding. 1, 3 or 4 channels. Written to a temporary and renamed. Throws Error(output), or
// Error(usage) for an extension that is not known.
void write(const std::filesystem::path& path, const Image& image);

// As write, for .exr only: named channels (each one plane of width * height) and header attributes.
struct Exr {
  int width = 0, height = 0;
  std::map<std::string, std::vector<float>> channels; // "R", "G", "B", "stderr.R", "id", ...
  std::map<std::string, std::string> attributes;
  bool half = false; // stored as 16-bit floats
};
Exr read_exr(const std::filesystem::path& path);
void write_exr(const std::filesystem::path& path, const Exr& exr);

// Decodes PNG, JPEG or WebP from memory. `name` is used in messages. Throws Error(input).
Image8 decode(const std::byte* data, std::size_t size, const std::string& name);

// True if write() knows the extension.
bool is_writable_extension(const std::filesystem::path& path);

} // namespace gg::image
