// Triangle lists out of glTF's primitive modes.
#pragma once

#include <cstdint>
#include <vector>

namespace gg::scene::gltf {

enum class Mode { points, lines, line_loop, line_strip, triangles, strip, fan };

inline bool is_drawn(Mode mode) {
  return mode >= Mode::triangles;
}

// Three corners per triangle, in the order of glTF 2.0 §3.7.2.1. Corners that do not complete a
// triangle are dropped, and so are the triangles of a strip with two equal corners, which only
// stitch it together.
std::vector<std::uint32_t> triangle_list(std::vector<std::uint32_t> corners, Mode mode);

} // namespace gg::scene::gltf
