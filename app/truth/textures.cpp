#include "truth/textures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gg::truth {
namespace {

using Table = std::array<double, 256>;

const Table& decoder(Encoding encoding) {
  static const std::array<Table, 2> tables = [] {
    std::array<Table, 2> t{};
    for (std::size_t i = 0; i < 256; ++i) {
      t[0][i] = static_cast<double>(i) / 255.0;
      t[1][i] = image::linear_from_srgb(t[0][i]);
    }
    return t;
  }();
  return tables[encoding == Encoding::srgb];
}

// The texel that index i falls on, for a side of n texels.
int wrapped(long long i, int n, scene::Wrap wrap) {
  switch (wrap) {
  case scene::Wrap::clamp:
    return static_cast<int>(std::clamp<long long>(i, 0, n - 1));
  case scene::Wrap::mirrored_repeat: {
    const long long period = ((i % (2LL * n)) + 2LL * n) % (2LL * n);
    return static_cast<int>(period < n ? period : 2LL * n - 1 - period);
  }
  case scene::Wrap::repeat:
    break;
  }
  return static_cast<int>(((i % n) + n) % n);
}

glm::dvec4 texel(const image::Image8& image, int x, int y, const Table& decode) {
  const std::size_t at = 4
                         * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width)
                            + static_cast<std::size_t>(x));
  const std::uint8_t* rgba = image.rgba.data() + at;
  return {decode[rgba[0]], decode[rgba[1]], decode[rgba[2]], static_cast<double>(rgba[3]) / 255.0};
}

} // namespace

glm::dvec4 Textures::at(const scene::Slot& slot, glm::dvec2 uv, Encoding encoding) const {
  const scene::Texture& texture = scene_.textures[static_cast<std::size_t>(slot.texture)];
  if (texture.image == scene::none || !scene_.images[static_cast<std::size_t>(texture.image)])
    return glm::dvec4(1.0);
  const image::Image8& image = *scene_.images[static_cast<std::size_t>(texture.image)];
  const scene::Sampler& sampler = texture.sampler;
  const Table& decode = decoder(encoding);

  const glm::dvec3 moved = glm::dmat3(slot.transform) * glm::dvec3(uv, 1.0);
  // Beyond 2^40 texels the position in the texture has no meaning left; keep the integers in range.
  const double limit = 0x1p40;
  const double x = std::clamp(moved.x * image.width, -limit, limit);
  const double y = std::clamp(moved.y * image.height, -limit, limit);
  if (!(x == x && y == y)) return glm::dvec4(1.0);
  const auto column = [&](long long i) { return wrapped(i, image.width, sampler.wrap_s); };
  const auto row = [&](long long i) { return wrapped(i, image.height, sampler.wrap_t); };
  if (sampler.magnify == scene::Filter::nearest)
    return texel(image, column(static_cast<long long>(std::floor(x))),
                 row(static_cast<long long>(std::floor(y))), decode);

  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const double fx = x - 0.5 - left, fy = y - 0.5 - top;
  const long long i = static_cast<long long>(left), j = static_cast<long long>(top);
  const int x0 = column(i), x1 = column(i + 1), y0 = row(j), y1 = row(j + 1);
  return (texel(image, x0, y0, decode) * (1.0 - fx) + texel(image, x1, y0, decode) * fx)
             * (1.0 - fy)
         + (texel(image, x0, y1, decode) * (1.0 - fx) + texel(image, x1, y1, decode) * fx) * fy;
}

} // namespace gg::truth
