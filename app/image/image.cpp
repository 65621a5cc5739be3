#include "image/image.h"

#include "core/error.h"
#include "core/files.h"
#include "glsl/f64.h"
#include "image/formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace gg::image {
namespace {

using formats::Format;

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

Format format_of_extension(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".hdr") return Format::hdr;
  if (extension == ".exr") return Format::exr;
  if (extension == ".pfm") return Format::pfm;
  if (extension == ".png") return Format::png;
  if (extension == ".jpg" || extension == ".jpeg") return Format::jpeg;
  // Standard output and devices have no extension to say more.
  if (extension.empty() && destination_of(path).is_stream) return Format::png;
  return Format::unknown;
}

void write_bytes(const std::filesystem::path& path, const std::vector<std::byte>& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

Exr exr_from(const Image& image) {
  static const std::array<const char*, 4> grey{"Y"}, colour{"R", "G", "B", "A"};
  const auto& names = image.channels == 1 ? grey : colour;
  Exr exr;
  exr.width = image.width;
  exr.height = image.height;
  const std::size_t pixels = image.values.size() / static_cast<std::size_t>(image.channels);
  for (int c = 0; c < image.channels; ++c) {
    std::vector<float>& plane = exr.channels[names[static_cast<std::size_t>(c)]];
    plane.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
      plane[i] =
          image.values[i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(c)];
  }
  return exr;
}

Image linear_from(const Image8& encoded) {
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255.0));
  bool opaque = true;
  for (std::size_t i = 3; i < encoded.rgba.size(); i += 4)
    opaque &= encoded.rgba[i] == 255;
  Image image(encoded.width, encoded.height, opaque ? 3 : 4);
  const std::size_t channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < encoded.rgba.size() / 4; ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      image.values[i * channels + c] = linear[encoded.rgba[i * 4 + c]];
    if (!opaque)
      image.values[i * channels + 3] = static_cast<float>(encoded.rgba[i * 4 + 3]) / 255.0f;
  }
  return image;
}

// A picture that contradicts itself is a fault of the caller, not of a file.
void check_consistent(const std::filesystem::path& path, const Image& image) {
  const bool channels_known = image.channels == 1 || image.channels == 3 || image.channels == 4;
  if (!channels_known || image.width < 1 || image.height < 1
      || image.values.size() != image.index(0, image.height))
    throw Error(ExitCode::internal, path,
                "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height)
                    + " pixels, " + std::to_string(image.channels) + " channels and "
                    + std::to_string(image.values.size()) + " values cannot be written");
}

void check_no_nan(const std::filesystem::path& path, const Image& image) {
  const auto nan =
      std::find_if(image.values.begin(), image.values.end(), [](float v) { return std::isnan(v); });
  if (nan == image.values.end()) return;
  const auto pixel = (nan - image.values.begin()) / image.channels;
  throw Error(ExitCode::output, path,
              "the picture's pixel (" + std::to_string(pixel % image.width) + ", "
                  + std::to_string(pixel / image.width) + ") is not a number, which "
                  + path.extension().string() + " cannot hold",
              "Write .exr to see where the others are.");
}

} // namespace

Image read(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = read_file(path);
  const std::string name = path.string();
  switch (formats::recognise(bytes)) {
  case Format::hdr:
    return formats::read_hdr(bytes, name);
  case Format::pfm:
    return formats::read_pfm(bytes, name);
  case Format::exr:
    return formats::read_exr_colour(bytes, name);
  case Format::png:
  case Format::jpeg:
  case Format::webp:
  case Format::ktx2:
    return linear_from(decode(bytes.data(), bytes.size(), name));
  case Format::unknown:
    break;
  }
  throw Error(ExitCode::input, name,
              bytes.empty() ? "is empty" : "is not a picture in a known format",
              "Known are Radiance .hdr, OpenEXR .exr, .pfm, .png, .jpg, .webp and .ktx2.");
}

Exr read_exr(const std::filesystem::path& path) {
  return formats::read_exr(read_file(path), path.string());
}

void write(const std::filesystem::path& path, const Image& image) {
  const Format format = format_of_extension(path);
  if (format == Format::unknown)
    throw Error(ExitCode::usage, path, "has an extension that cannot be written",
                "Use .exr, .hdr, .pfm (linear), .png or .jpg (8-bit).");
  check_consistent(path, image);
  if (format == Format::exr) return write_exr(path, exr_from(image));
  if (format == Format::pfm) return write_bytes(path, formats::encode_pfm(image));
  check_no_nan(path, image);
  write_bytes(path, format == Format::hdr    ? formats::encode_hdr(image)
                    : format == Format::jpeg ? formats::encode_jpeg(image, path.string())
                                             : formats::encode_png(image, path.string()));
}

void write_exr(const std::filesystem::path& path, const Exr& exr) {
  write_bytes(path, formats::encode_exr(exr, path.string()));
}

bool is_writable_extension(const std::filesystem::path& path) {
  return format_of_extension(path) != Format::unknown;
}

bool is_display_extension(const std::filesystem::path& path) {
  const Format format = format_of_extension(path);
  return format == Format::png || format == Format::jpeg;
}

std::optional<NonFinite> find_non_finite(const Image& image) {
  std::optional<NonFinite> first;
  const std::size_t channels = static_cast<std::size_t>(std::max(image.channels, 1));
  for (std::size_t i = 0; i + channels <= image.values.size(); i += channels) {
    const auto begin = image.values.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = begin + static_cast<std::ptrdiff_t>(channels);
    const auto bad = std::find_if_not(begin, end, [](float v) { return std::isfinite(v); });
    if (bad == end) continue;
    if (!first) {
      const int pixel = static_cast<int>(i / channels);
      first = NonFinite{.x = pixel % image.width,
                        .y = pixel / image.width,
                        .channel = static_cast<int>(bad - begin),
                        .value = *bad};
    }
    ++first->pixels;
  }
  return first;
}

void require_finite(const Image& image, const std::string& where) {
  const std::optional<NonFinite> bad = find_non_finite(image);
  if (!bad) return;
  throw Error(ExitCode::input,
              where + ", pixel (" + std::to_string(bad->x) + ", " + std::to_string(bad->y) + ")",
              "is " + std::to_string(bad->value)
                  + "; pixels that are not finite: " + std::to_string(bad->pixels),
              "Repair these pixels, or render the picture again.");
}

double srgb_from_linear(double linear) {
  return glsl::f64::srgbFromLinear(linear);
}

double linear_from_srgb(double encoded) {
  return glsl::f64::linearFromSrgb(encoded);
}

} // namespace gg::image
