// Pictures in memory and on disk. Linear floating point throughout; the display transform is in
// shaders/color.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gg::image {

// What is accepted of any file, checked against the size that it declares before memory is taken:
// no more pixels than a 16384 x 8192 environment (1.6 GB as RGB floats, 0.5 GB as 8-bit RGBA) and
// no side longer than 65536. A small file that declares a huge picture is refused sooner where the
// format bounds how well it can compress.
inline constexpr long long max_pixels = 1LL << 27;
inline constexpr long long max_side = 1LL << 16;

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

// Linear pictures: .hdr (Radiance RGBE, flat, old and new run-length encoding, all eight
// orientations, EXPOSURE and COLORCORR undone), .exr (colour channels), .pfm, and .png, .jpg, .webp
// (8-bit sRGB, made linear), .ktx2. The format is told by the content, not by the extension. `channels` of
// the result is 3 or 4; grey becomes RGB. Values are what the file says, NaN and infinities
// included: see find_non_finite. Throws Error(input) naming the file, the place and what is wrong.
Image read(const std::filesystem::path& path);

// Writes linear values by extension: .exr (float), .hdr (RGBE: steps of 1/255 to 1/128 of a pixel's
// largest channel, rounded to the nearest; negative values become 0, a fourth channel is dropped),
// .pfm (a fourth channel is dropped); and .png: the values, clamped to 0..1, are taken as
// display-encoded already and quantised to 8 bits with rounding; .jpg the same, compressed with loss. 1, 3 or 4 channels.
// Standard output ("-") and devices without an extension are given .png. Written to a temporary and
// renamed. Throws Error(output), also for a NaN where the format has none (.hdr,
// .png), or Error(usage) for an extension that is not known.
void write(const std::filesystem::path& path, const Image& image);

// As write, for .exr only: named channels (each one plane of width * height) and header attributes.
struct Exr {
  int width = 0, height = 0;
  std::map<std::string, std::vector<float>> channels; // "R", "G", "B", "stderr.R", "id", ...
  std::map<std::string, std::string> attributes;
  // Channels are stored as 16-bit floats (largest 65504), except "id", which stays exact. read_exr
  // sets it if every channel but "id" was stored so.
  bool half = false;
};
// Reads every channel of the first part, of scan-line and tiled files, as floats. The size is the
// display window's: what the data window lacks of it is 0, what it has beside it is dropped, with a note. Attributes of type
// string, int, float and double are kept, as text.
Exr read_exr(const std::filesystem::path& path);
void write_exr(const std::filesystem::path& path, const Exr& exr);

// Decodes PNG, JPEG, WebP or KTX2 from memory, up to max_pixels. Colour profiles and gamma are ignored,
// as glTF asks; 16-bit PNG is rounded to 8; CMYK JPEG and animated WebP are refused. `name` is used
// in messages. Throws Error(input), or Error(unsupported) for KTX2 where there is no libktx.
Image8 decode(const std::byte* data, std::size_t size, const std::string& name);

// True if a libktx was found, which reads KTX2 (ktx2.cpp says where it is looked for); and what to do where it was not.
bool can_decode_ktx2();
inline constexpr const char* without_libktx =
    "Run app/setup --ktx2 or install libktx 4 (KTX-Software), or export with PNG, JPEG or WebP "
    "images.";

// The first value that is NaN or infinite, in reading order, and how many pixels have one.
struct NonFinite {
  int x = 0, y = 0, channel = 0;
  float value = 0.0f;
  std::size_t pixels = 0;
};
std::optional<NonFinite> find_non_finite(const Image& image);
// Throws Error(input) naming `where`, the first such pixel and their number, if there is one.
void require_finite(const Image& image, const std::string& where);

// The transfer function of sRGB (IEC 61966-2-1), both ways; values outside 0..1 are clamped.
double srgb_from_linear(double linear);
double linear_from_srgb(double encoded);

// True if write() knows the extension.
bool is_writable_extension(const std::filesystem::path& path);
// Whether write takes values for it as display-encoded: .png and .jpg.
bool is_display_extension(const std::filesystem::path& path);

} // namespace gg::image
