// Which format it is, and the 8-bit formats' common front.
#include "core/error.h"
#include "image/formats.h"

#include <cstring>

namespace gg::image {
namespace formats {
namespace {

bool has(Bytes bytes, std::string_view magic, std::size_t offset = 0) {
  return bytes.size() >= offset + magic.size()
         && std::memcmp(bytes.data() + offset, magic.data(), magic.size()) == 0;
}

} // namespace

Format recognise(Bytes bytes) {
  if (has(bytes, "#?")) return Format::hdr;
  if (has(bytes, "\x76\x2f\x31\x01")) return Format::exr;
  if ((has(bytes, "PF") || has(bytes, "Pf")) && bytes.size() > 2
      && std::string_view(" \t\r\n").find(static_cast<char>(bytes[2])) != std::string_view::npos)
    return Format::pfm;
  if (has(bytes, "\x89PNG\r\n\x1a\n")) return Format::png;
  if (has(bytes, "\xff\xd8\xff")) return Format::jpeg;
  if (has(bytes, "RIFF") && has(bytes, "WEBP", 8)) return Format::webp;
  if (has(bytes, "\xabKTX 20\xbb")) return Format::ktx2;
  return Format::unknown;
}

void check_size(const std::string& where, long long width, long long height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width < 1 || height < 1)
    throw Error(ExitCode::input, where, "declares " + size + " pixels, which is no picture",
                "Write the file again with the program that made it.");
  if (width > max_side || height > max_side || width * height > max_pixels)
    throw Error(ExitCode::input, where, "declares " + size + " pixels, more than are accepted",
                "Scale it down: at most " + std::to_string(max_pixels) + " pixels and "
                    + std::to_string(max_side) + " on a side.");
}

} // namespace formats

namespace {

template <class Result>
using Reader = Result (*)(formats::Bytes, const std::string&);

// By the format's own function.
template <class Result>
Result read_by(Reader<Result> png, Reader<Result> jpeg, Reader<Result> webp, Reader<Result> ktx2,
               formats::Bytes bytes, const std::string& name) {
  switch (formats::recognise(bytes)) {
  case formats::Format::png:
    return png(bytes, name);
  case formats::Format::jpeg:
    return jpeg(bytes, name);
  case formats::Format::webp:
    return webp(bytes, name);
  case formats::Format::ktx2:
    return ktx2(bytes, name);
  default:
    break;
  }
  throw Error(ExitCode::input, name,
              bytes.empty() ? "is empty" : "is not a PNG, JPEG or WebP picture",
              "Convert it to one of these.");
}

} // namespace

Image8 decode(const std::byte* data, std::size_t size, const std::string& name) {
  return read_by<Image8>(formats::decode_png, formats::decode_jpeg, formats::decode_webp,
                         formats::decode_ktx2, {data, size}, name);
}

Size size_of(const std::byte* data, std::size_t size, const std::string& name) {
  return read_by<Size>(formats::size_of_png, formats::size_of_jpeg, formats::size_of_webp,
                       formats::size_of_ktx2, {data, size}, name);
}

} // namespace gg::image
