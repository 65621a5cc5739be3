// WebP, lossy and lossless, by libwebp.
#include "core/error.h"
#include "image/formats.h"

#include <webp/decode.h>

namespace gg::image::formats {

namespace {

const std::uint8_t* data_of(Bytes bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

[[noreturn]] void fail(const std::string& name) {
  throw Error(ExitCode::input, name, "is truncated or malformed",
              "Download or write the file again.");
}

} // namespace

Size size_of_webp(Bytes bytes, const std::string& name) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data_of(bytes), bytes.size(), &features) != VP8_STATUS_OK) fail(name);
  if (features.has_animation)
    throw Error(ExitCode::input, name, "is an animation", "Save one frame of it as a picture.");
  check_size(name, features.width, features.height);
  return {features.width, features.height};
}

Image8 decode_webp(Bytes bytes, const std::string& name) {
  const auto [width, height] = size_of_webp(bytes, name);
  Image8 image{.width = width, .height = height, .rgba = {}};
  const int pitch = 4 * width;
  image.rgba.resize(static_cast<std::size_t>(pitch) * static_cast<std::size_t>(height));
  if (!WebPDecodeRGBAInto(data_of(bytes), bytes.size(), image.rgba.data(), image.rgba.size(),
                          pitch))
    fail(name);
  return image;
}

} // namespace gg::image::formats
