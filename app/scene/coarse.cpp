#include "scene/coarse.h"

#include <meshoptimizer.h>

#include <set>

namespace gg::scene {
namespace {

constexpr float greatest_errors[] = {0.003f, 0.01f, 0.03f}; // of the mesh's size
constexpr std::size_t fewest_triangles = 500;               // of a list that is worth it

CoarseList coarsened(const Indices& whole, const Stream& positions, float greatest_error) {
  constexpr std::size_t stride = 3 * sizeof(float);
  CoarseList coarse{.indices = Indices(whole.size())};
  float error = 0.0f; // of the mesh's size
  const std::size_t count =
      meshopt_simplify(coarse.indices.data(), whole.data(), whole.size(), positions.values.data(),
                       positions.count(), stride, 0, greatest_error, 0, &error);
  coarse.indices.resize(count);
  coarse.error = error * meshopt_simplifyScale(positions.values.data(), positions.count(), stride);
  return coarse;
}

} // namespace

CoarseLists coarse_lists(const Scene& scene) {
  std::map<Index, std::set<Index>> positions_of;
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives)
      positions_of[primitive.indices].insert(primitive.positions);
  CoarseLists lists;
  for (const auto& [list, positions] : positions_of) {
    const Indices& whole = scene.indices[static_cast<std::size_t>(list)];
    if (positions.size() > 1 || whole.size() < 3 * fewest_triangles) continue;
    const Stream& stream = scene.streams[static_cast<std::size_t>(*positions.begin())];
    std::vector<CoarseList> levels;
    for (const float error : greatest_errors) {
      const Indices& finer = levels.empty() ? whole : levels.back().indices;
      if (finer.size() < 3 * fewest_triangles) break;
      CoarseList coarse = coarsened(finer, stream, error);
      if (coarse.indices.empty() || 2 * coarse.indices.size() > finer.size()) continue;
      if (!levels.empty()) coarse.error += levels.back().error;
      levels.push_back(std::move(coarse));
    }
    if (!levels.empty()) lists.emplace(list, std::move(levels));
  }
  return lists;
}

} // namespace gg::scene
