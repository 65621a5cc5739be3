// Triangles whose corners at one place are one vertex, whatever the file's indices say.
#pragma once

#include "scene/scene.h"

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace gg::scene {

using Triangle = std::array<std::uint32_t, 3>;

// Positions are rounded to 14 bits of the largest side by common optimisers (gltfpack, glTF-Transform, Draco in
// Blender), and to 16 by others.
inline constexpr double coarsest_quantum = 0x1p-14;

struct WeldedMesh {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles; // of three different points
  double largest = 0.0;            // coordinate, by magnitude
  double size = 0.0;               // the longest side of the box around them
};

// The triangles at an edge, by the direction in which they pass it; the key's first point is the lower.
struct Edge {
  std::vector<std::size_t> along, against;
  bool is_open() const { return along.size() != against.size(); }
};
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, Edge>;
Edges edges_of(const WeldedMesh& mesh);

// All triangles of `parts`, with points closer than a millionth of the size (or the rounding of their coordinates) made
// one: where a generator closes a surface, sin 2 pi is not sin 0. Points on edges that are still open then are welded
// within one step of coarsest_quantum: rounding moves the two sides of such a seam to neighbouring steps.
WeldedMesh weld(const Scene& scene, std::span<const Primitive* const> parts);

} // namespace gg::scene
