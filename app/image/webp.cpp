// WebP, lossy and lossless, by libwebp.
#include "core/error.h"
#include "image/formats.h"

#include <webp/decode.h>

namespace gg::image::formats {

Image8 decode_webp(Bytes bytes, const std::string& name) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  const auto malformed = [&] {
    return Error(ExitCode::input, name, "is truncated or malformed",
                 "Download or write the file again.");
  };
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK) throw malformed();
  if (features.has_animation)
    throw Error(ExitCode::input, name, "is an animation", "Save one frame of it as a picture.");
  check_size(name, features.width, features.height);
  Image8 image{.width = features.width, .height = features.height, .rgba = {}};
  const int pitch = 4 * features.width;
  image.rgba.resize(static_cast<std::size_t>(pitch) * static_cast<std::size_t>(features.height));
  if (!WebPDecodeRGBAInto(data, bytes.size(), image.rgba.data(), image.rgba.size(), pitch))
    throw malformed();
  return image;
}

} // namespace gg::image::formats
