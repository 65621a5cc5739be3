#include "scene/bodies.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace gg::scene {
namespace {

// Places are numbered over all parts of a mesh, so that parts can be seen to meet.
using Place = std::uint32_t;
class Places {
public:
  explicit Places(const Scene& scene) : scene_(scene) {}
  Place of(const Primitive& part, std::uint32_t vertex) {
    const Stream& positions = scene_.streams[static_cast<std::size_t>(part.positions)];
    const float* p = positions.values.data() + 3 * static_cast<std::size_t>(vertex);
    // Of 0 and -0 the sum with 0 is 0.
    return known_
        .try_emplace({p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f}, static_cast<Place>(known_.size()))
        .first->second;
  }

private:
  const Scene& scene_;
  std::map<std::array<float, 3>, Place> known_;
};

// The edges of the parts of one material that its triangles do not pass as often one way as the
// other.
using Edges = std::set<std::pair<Place, Place>>;

Edges open_edges(const Scene& scene, const Mesh& mesh, Index material, Places& places) {
  std::map<std::pair<Place, Place>, int> balance;
  for (const Primitive& part : mesh.primitives) {
    if (part.material != material) continue;
    const Indices& indices = scene.indices[static_cast<std::size_t>(part.indices)];
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      std::array<Place, 3> at{};
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = places.of(part, indices[i + k]);
      for (std::size_t k = 0; k < 3; ++k)
        if (const Place a = at[k], b = at[(k + 1) % 3]; a != b)
          balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  Edges open;
  for (const auto& [edge, sum] : balance)
    if (sum != 0) open.insert(edge);
  return open;
}

bool meet(const Edges& a, const Edges& b) {
  return std::ranges::any_of(a, [&](const auto& edge) { return b.contains(edge); });
}

} // namespace

bool is_solid(const Material& m) {
  return m.transmission > 0.0f && m.thickness > 0.0f && !m.unlit;
}

std::vector<Index> body_materials(const Scene& scene) {
  std::vector<Index> stands_in(scene.materials.size());
  std::iota(stands_in.begin(), stands_in.end(), 0);
  const auto join = [&](Index a, Index b) {
    const Index one = stands_in[static_cast<std::size_t>(a)];
    const Index other = stands_in[static_cast<std::size_t>(b)];
    std::ranges::replace(stands_in, std::max(one, other), std::min(one, other));
  };
  for (const Mesh& mesh : scene.meshes) {
    std::set<Index> solids;
    for (const Primitive& part : mesh.primitives)
      if (is_solid(scene.materials[static_cast<std::size_t>(part.material)]))
        solids.insert(part.material);
    if (solids.size() < 2) continue;
    Places places(scene);
    std::map<Index, Edges> open;
    for (const Index material : solids)
      open[material] = open_edges(scene, mesh, material, places);
    for (const auto& [a, edges] : open)
      for (const auto& [b, others] : open)
        if (a < b && meet(edges, others)) join(a, b);
  }
  return stands_in;
}

} // namespace gg::scene
