#include "gpu/types.h"

#include <bit>

namespace gg::gpu {

std::size_t bytes_per_texel(Format format) {
  switch (format) {
  case Format::none:
    return 0;
  case Format::r8:
    return 1;
  case Format::rg8:
  case Format::r16f:
    return 2;
  case Format::rgba8:
  case Format::rgba8_srgb:
  case Format::rg16f:
  case Format::r32f:
  case Format::r32ui:
  case Format::depth32f:
    return 4;
  case Format::rgba16f:
  case Format::rg32f:
  case Format::rg32ui:
    return 8;
  case Format::rgba32f:
  case Format::rgba32ui:
    return 16;
  }
  return 0;
}

Constant constant(std::uint32_t id, bool value) {
  return {id, value ? 1u : 0u};
}
Constant constant(std::uint32_t id, std::int32_t value) {
  return {id, std::bit_cast<std::uint32_t>(value)};
}
Constant constant(std::uint32_t id, std::uint32_t value) {
  return {id, value};
}
Constant constant(std::uint32_t id, float value) {
  return {id, std::bit_cast<std::uint32_t>(value)};
}

View whole(const TextureRef& texture) {
  return {texture, 0, texture->desc.levels, 0, extent(texture->desc, 0).layers};
}

Extent extent(const TextureDesc& desc, int level) {
  const auto shrunk = [level](int size) { return size >> level > 1 ? size >> level : 1; };
  Extent result{shrunk(desc.width), shrunk(desc.height), desc.layers};
  if (desc.shape == Shape::d3) result.layers = shrunk(desc.layers);
  if (desc.shape == Shape::cube || desc.shape == Shape::cube_array) result.layers *= 6;
  return result;
}

int max_levels(const TextureDesc& desc) {
  int largest = desc.width > desc.height ? desc.width : desc.height;
  if (desc.shape == Shape::d3 && desc.layers > largest) largest = desc.layers;
  return std::bit_width(static_cast<unsigned>(largest));
}

std::size_t bytes(const TextureDesc& desc) {
  std::size_t texels = 0;
  for (int level = 0; level < desc.levels; ++level) {
    const Extent size = extent(desc, level);
    texels += static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)
              * static_cast<std::size_t>(size.layers);
  }
  return texels * bytes_per_texel(desc.format);
}

} // namespace gg::gpu
