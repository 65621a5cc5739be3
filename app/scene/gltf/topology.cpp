#include "scene/gltf/topology.h"

namespace gg::scene::gltf {

std::vector<std::uint32_t> triangle_list(std::vector<std::uint32_t> corners, Mode mode) {
  if (mode == Mode::triangles) {
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  std::vector<std::uint32_t> list;
  if (corners.size() < 3) return list;
  list.reserve(3 * (corners.size() - 2));
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    // Every other triangle of a strip is wound the other way round.
    const std::size_t odd = i % 2;
    const std::uint32_t a = mode == Mode::fan ? corners[i + 1] : corners[i];
    const std::uint32_t b = mode == Mode::fan ? corners[i + 2] : corners[i + 1 + odd];
    const std::uint32_t c = mode == Mode::fan ? corners[0] : corners[i + 2 - odd];
    if (mode == Mode::fan || (a != b && b != c && c != a)) list.insert(list.end(), {a, b, c});
  }
  return list;
}

} // namespace gg::scene::gltf
