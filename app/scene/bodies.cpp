#include "scene/bodies.h"

#include "scene/solid_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <span>

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

using Corners = std::array<glm::dvec3, 3>;

std::vector<Corners> triangles_of(const Scene& scene, std::span<const Primitive* const> parts) {
  std::vector<Corners> triangles;
  for (const Primitive* part : parts) {
    const Stream& positions = scene.streams[static_cast<std::size_t>(part->positions)];
    const Indices& indices = scene.indices[static_cast<std::size_t>(part->indices)];
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      Corners& corners = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const float* p = positions.values.data() + 3 * static_cast<std::size_t>(indices[i + k]);
        corners[k] = {p[0], p[1], p[2]};
      }
    }
  }
  return triangles;
}

// How often the surface goes around the point: 1 within a closed one [Jacobson13]. Of one triangle
// the solid angle, signed [VanOosterom83].
double winding_number(const std::vector<Corners>& triangles, const glm::dvec3& point) {
  double sum = 0.0;
  for (const Corners& t : triangles) {
    const glm::dvec3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += 2.0
           * std::atan2(glm::dot(a, glm::cross(b, c)), la * lb * lc + glm::dot(a, b) * lc
                                                           + glm::dot(b, c) * la
                                                           + glm::dot(c, a) * lb);
  }
  return sum / (4.0 * std::numbers::pi);
}

// The mean of the winding number just behind the surface, by some points on it. A flat sheet has 1/2
// there, a hemisphere's shell over .8, a ball with a small hole .99, anything closed 1.
double winding_behind(const std::vector<Corners>& triangles) {
  constexpr std::size_t points = 64;
  double area = 0.0, size = 0.0;
  std::vector<double> cumulated;
  for (const Corners& t : triangles) {
    area += glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
    cumulated.push_back(area);
    for (const glm::dvec3& corner : t)
      size = std::max(size, glm::distance(corner, triangles[0][0]));
  }
  if (!(area > 0.0)) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < points; ++k) {
    const double at = area * (static_cast<double>(k) + 0.5) / points;
    const auto found = std::ranges::lower_bound(cumulated, at);
    const Corners& t = triangles[static_cast<std::size_t>(found - cumulated.begin())];
    const glm::dvec3 n = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
    constexpr double just_behind = 1e-4; // of the size: above rounding, below any wall
    sum += winding_number(triangles, (t[0] + t[1] + t[2]) / 3.0 - just_behind * size * n);
  }
  return sum / points;
}

} // namespace

bool Bodies::has_inside(Index mesh, Index material) {
  if (!is_solid(scene_.materials[static_cast<std::size_t>(material)])) return false;
  const Index body = stands_in_[static_cast<std::size_t>(material)];
  const auto [at, is_new] = known_.try_emplace({mesh, body}, true);
  if (!is_new) return at->second;
  std::vector<const Primitive*> parts;
  for (const Primitive& part : scene_.meshes[static_cast<std::size_t>(mesh)].primitives)
    if (stands_in_[static_cast<std::size_t>(part.material)] == body) parts.push_back(&part);
  constexpr double closed_enough = 0.9;
  return at->second = solid_shape(scene_, parts).closed
                      || winding_behind(triangles_of(scene_, parts)) > closed_enough;
}

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
