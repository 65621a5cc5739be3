#include "scene/solid_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace gg::scene {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Welded {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles; // of three different points
  double largest = 0.0;            // coordinate, by magnitude
};

// A face of one plane has one normal at all its corners, whatever it was rounded to: to 8 bits, up to
// .4 degrees.
constexpr double flat_cosine = 0.99985; // of 1 degree

glm::dvec3 vector_at(const Stream& stream, std::uint32_t i) {
  const float* v = stream.values.data() + 3 * static_cast<std::size_t>(i);
  return {v[0], v[1], v[2]};
}

const Stream& stream_of(const Scene& scene, Index i) {
  return scene.streams[static_cast<std::size_t>(i)];
}

const Indices& indices_of(const Scene& scene, const Primitive& part) {
  return scene.indices[static_cast<std::size_t>(part.indices)];
}

Welded weld(const Scene& scene, std::span<const Primitive* const> parts) {
  Welded mesh;
  std::map<std::array<double, 3>, std::uint32_t> known;
  for (const Primitive* part : parts) {
    const Stream& positions = stream_of(scene, part->positions);
    const Indices& indices = indices_of(scene, *part);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      Triangle triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 p = vector_at(positions, indices[i + k]);
        const auto [entry, is_new] =
            known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(mesh.points.size()));
        if (is_new) {
          mesh.points.push_back(p);
          mesh.largest = std::max({mesh.largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        }
        triangle[k] = entry->second;
      }
      const auto [a, b, c] = triangle;
      if (a != b && b != c && c != a) mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

// The triangles at an edge, by the direction in which they pass it.
struct Edge {
  std::vector<std::size_t> along, against;
};
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, Edge>;

Edges edges_of(const Welded& mesh) {
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

bool in_one_piece(const Welded& mesh) {
  std::vector<std::uint32_t> root(mesh.points.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    root[find(a)] = find(b);
    root[find(b)] = find(c);
  }
  for (const Triangle& triangle : mesh.triangles)
    if (find(triangle[0]) != find(mesh.triangles.front()[0])) return false;
  return true;
}

// Does the corner of `other` that is not on the edge lie before the plane of `triangle`? Coordinates
// are rounded to 2^-24 of themselves; a triangle of height h over the edge tilts by that over h, which
// moves its plane by reach / h times as much where the corner is. Eight such roundings cover its three
// corners and the corner in question.
bool turns_inwards(const Welded& mesh, const Triangle& triangle, const Triangle& other,
                   std::uint32_t a, std::uint32_t b) {
  const auto corner = std::ranges::find_if(other, [&](auto i) { return i != a && i != b; });
  const glm::dvec3 from = mesh.points[a], edge = mesh.points[b] - from;
  const glm::dvec3 to = mesh.points[*corner] - from;
  const glm::dvec3 normal = glm::cross(mesh.points[triangle[1]] - mesh.points[triangle[0]],
                                       mesh.points[triangle[2]] - mesh.points[triangle[0]]);
  const double area = glm::length(normal);
  if (!(area > 0.0)) return false; // a needle has no plane; its neighbours meet others
  const double reach = glm::length(glm::cross(to, edge));
  const double rounding = 8.0 * 0x1p-24 * mesh.largest * (1.0 + reach / area);
  return glm::dot(to, normal) / area > rounding;
}

bool is_flat(const Scene& scene, std::span<const Primitive* const> parts) {
  for (const Primitive* part : parts) {
    const Stream& positions = stream_of(scene, part->positions);
    const Stream& normals = stream_of(scene, part->normals);
    const Indices& indices = indices_of(scene, *part);
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const glm::dvec3 a = vector_at(positions, indices[i]);
      const glm::dvec3 normal = glm::cross(vector_at(positions, indices[i + 1]) - a,
                                           vector_at(positions, indices[i + 2]) - a);
      const glm::dvec3 n = vector_at(normals, indices[i]);
      if (n != vector_at(normals, indices[i + 1]) || n != vector_at(normals, indices[i + 2])
          || glm::dot(n, normal) < flat_cosine * glm::length(n) * glm::length(normal))
        return false;
    }
  }
  return true;
}

} // namespace

SolidShape solid_shape(const Scene& scene, std::span<const Primitive* const> parts) {
  SolidShape shape;
  const Welded mesh = weld(scene, parts);
  if (mesh.triangles.empty()) return shape;
  shape.flat = is_flat(scene, parts);
  const Edges edges = edges_of(mesh);
  shape.closed = std::ranges::all_of(edges, [](const auto& entry) {
    return entry.second.along.size() == entry.second.against.size();
  });
  if (!shape.closed || !in_one_piece(mesh)) return shape;
  shape.convex = std::ranges::all_of(edges, [&](const auto& entry) {
    const auto& [ends, edge] = entry;
    if (edge.along.size() != 1) return false; // more than two triangles: bodies that touch
    const Triangle &one = mesh.triangles[edge.along[0]], &other = mesh.triangles[edge.against[0]];
    return !turns_inwards(mesh, one, other, ends.first, ends.second)
           && !turns_inwards(mesh, other, one, ends.first, ends.second);
  });
  return shape;
}

} // namespace gg::scene
