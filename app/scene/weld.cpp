#include "scene/weld.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <functional>
#include <numeric>
#include <string_view>
#include <unordered_map>

namespace gg::scene {
namespace {

constexpr double seam = 1e-6; // of the size: ten roundings of a float

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(&cell), sizeof cell});
  }
};

// Finds one of the points so far that is within reach, or takes a new one.
class Finder {
public:
  explicit Finder(double reach) : reach_(std::max(reach, DBL_MIN)) {}

  std::uint32_t find_or_add(const glm::dvec3& p, std::vector<glm::dvec3>& points) {
    // Cells are twice the reach wide, so that what is within it is in two of them along each axis at most.
    const glm::dvec3 low = (p - reach_) / (2.0 * reach_), high = (p + reach_) / (2.0 * reach_);
    const Cell first = cell_of(low), last = cell_of(high);
    for (std::int64_t x = first[0]; x <= last[0]; ++x)
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
        for (std::int64_t z = first[2]; z <= last[2]; ++z)
          if (const auto here = cells_.find({x, y, z}); here != cells_.end())
            for (const std::uint32_t i : here->second)
              if (glm::distance(points[i], p) <= reach_) return i;
    points.push_back(p);
    const auto index = static_cast<std::uint32_t>(points.size() - 1);
    cells_[cell_of(p / (2.0 * reach_))].push_back(index);
    return index;
  }

private:
  static Cell cell_of(const glm::dvec3& p) {
    return {std::llround(std::floor(p.x)), std::llround(std::floor(p.y)),
            std::llround(std::floor(p.z))};
  }

  double reach_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

template <class Visit>
void for_each_corner(const Scene& scene, std::span<const Primitive* const> parts,
                     const Visit& visit) {
  for (const Primitive* part : parts) {
    const float* const positions =
        scene.streams[static_cast<std::size_t>(part->positions)].values.data();
    const Indices& indices = scene.indices[static_cast<std::size_t>(part->indices)];
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      visit(part, std::array{indices[i], indices[i + 1], indices[i + 2]}, positions);
  }
}

glm::dvec3 point_at(const float* positions, std::uint32_t i) {
  return glm::make_vec3(positions + 3 * std::size_t{i});
}

void keep(Triangle triangle, std::vector<Triangle>& triangles) {
  const auto [a, b, c] = triangle;
  if (a != b && b != c && c != a) triangles.push_back(triangle);
}

void close_seams(WeldedMesh& mesh, double reach) {
  std::vector<bool> is_open(mesh.points.size(), false);
  bool any = false;
  for (const auto& [ends, edge] : edges_of(mesh))
    if (edge.is_open()) any = is_open[ends.first] = is_open[ends.second] = true;
  if (!any) return;
  std::vector<std::uint32_t> becomes(mesh.points.size());
  std::iota(becomes.begin(), becomes.end(), 0u);
  Finder finder(reach);
  std::vector<glm::dvec3> kept;
  std::vector<std::uint32_t> source;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (!is_open[i]) continue;
    const std::uint32_t at = finder.find_or_add(mesh.points[i], kept);
    if (at == source.size()) source.push_back(i);
    becomes[i] = source[at];
  }
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    keep({becomes[a], becomes[b], becomes[c]}, triangles);
  mesh.triangles = std::move(triangles);
}

} // namespace

Edges edges_of(const WeldedMesh& mesh) {
  Edges edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      if (a < b)
        edges[{a, b}].along.push_back(t);
      else
        edges[{b, a}].against.push_back(t);
    }
  return edges;
}

WeldedMesh weld(const Scene& scene, std::span<const Primitive* const> parts) {
  WeldedMesh mesh;
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for_each_corner(scene, parts, [&](const Primitive*, const Triangle& triangle, const float* from) {
    for (const std::uint32_t i : triangle) {
      const glm::dvec3 p = point_at(from, i), magnitude = glm::abs(p);
      low = glm::min(low, p), high = glm::max(high, p);
      mesh.largest = std::max({mesh.largest, magnitude.x, magnitude.y, magnitude.z});
    }
  });
  if (!(low.x <= high.x)) return mesh;
  mesh.size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  // Two roundings apart along each axis: 2 sqrt 3 times 2^-24 of the largest coordinate.
  Finder finder(std::max(seam * mesh.size, 4.0 * 0x1p-24 * mesh.largest));
  std::unordered_map<std::uint32_t, std::uint32_t> known; // of one part: by the file's index
  const Primitive* current = nullptr;
  for_each_corner(
      scene, parts, [&](const Primitive* part, const Triangle& triangle, const float* from) {
        if (part != current) known.clear();
        current = part;
        Triangle welded{};
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [entry, is_new] = known.try_emplace(triangle[k], 0u);
          if (is_new) entry->second = finder.find_or_add(point_at(from, triangle[k]), mesh.points);
          welded[k] = entry->second;
        }
        keep(welded, mesh.triangles);
      });
  // One step along each axis: sqrt 3.
  close_seams(mesh, 1.75 * coarsest_quantum * mesh.size);
  return mesh;
}

} // namespace gg::scene
