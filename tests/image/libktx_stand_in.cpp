// A library with the functions of libktx that the program calls, which transcodes nothing: pixel (x, y) of the largest level is
// (x, y, level count, 255), all others are 7. What a test has of libktx where none is installed.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace {

struct Texture {
  std::uint32_t width = 0, height = 0, levels = 0;
  std::vector<std::uint8_t> pixels;
};

std::uint32_t word(const std::uint8_t* bytes, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, bytes + at, sizeof value);
  return value;
}

constexpr int success = 0, invalid_operation = 10, unsupported_feature = 16;

} // namespace

extern "C" {

int ktxTexture2_CreateFromMemory(const std::uint8_t* bytes, std::size_t, std::uint32_t flags,
                                 Texture** made) {
  if (flags != 1) return invalid_operation; // without its pixels there is nothing to transcode
  *made = new Texture{
      .width = word(bytes, 20), .height = word(bytes, 24), .levels = word(bytes, 40), .pixels = {}};
  return success;
}

int ktxTexture2_TranscodeBasis(Texture* texture, int format, std::uint32_t) {
  constexpr int rgba32 = 13;
  if (format != rgba32) return unsupported_feature;
  for (std::uint32_t level = texture->levels; level-- > 1;)
    texture->pixels.resize(texture->pixels.size()
                               + 4 * std::max(texture->width >> level, 1u)
                                     * std::max(texture->height >> level, 1u),
                           7);
  for (std::uint32_t y = 0; y < texture->height; ++y)
    for (std::uint32_t x = 0; x < texture->width; ++x)
      for (const std::uint32_t value : {x, y, texture->levels, 255u})
        texture->pixels.push_back(static_cast<std::uint8_t>(value));
  return success;
}

std::uint8_t* ktxTexture_GetData(Texture* texture) {
  return texture->pixels.data();
}
std::size_t ktxTexture_GetDataSize(Texture* texture) {
  return texture->pixels.size();
}
void ktxTexture2_Destroy(Texture* texture) {
  delete texture;
}
const char* ktxErrorString(int) {
  return "an error of the stand-in";
}
}
