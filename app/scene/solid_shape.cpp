#include "scene/solid_shape.h"

#include "scene/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace gg::scene {
namespace {

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

bool in_one_piece(const WeldedMesh& mesh) {
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

struct Plane {
  glm::dvec3 through, normal; // unit, outwards
  double height;              // the least of the triangle
};

std::optional<Plane> plane_of(const WeldedMesh& mesh, const Triangle& triangle) {
  const auto [a, b, c] = triangle;
  const glm::dvec3 ab = mesh.points[b] - mesh.points[a], ac = mesh.points[c] - mesh.points[a];
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double area = glm::length(normal);
  if (!(area > 0.0)) return std::nullopt; // a needle has no plane; its neighbours meet others
  const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
  return Plane{mesh.points[a], normal / area, area / longest};
}

// Does the corner of `other` that is not on the edge lie before the plane of `triangle`, by more than coordinates that are
// off by `rounding` explain? A triangle of height h over the edge tilts by that over h, which moves its plane by
// reach / h times as much where the corner is. Eight such roundings cover its three corners and the corner in
// question.
bool turns_inwards(const WeldedMesh& mesh, const Triangle& triangle, const Triangle& other,
                   std::uint32_t a, std::uint32_t b, double rounding) {
  const auto corner = std::ranges::find_if(other, [&](auto i) { return i != a && i != b; });
  const glm::dvec3 from = mesh.points[a], edge = mesh.points[b] - from;
  const glm::dvec3 to = mesh.points[*corner] - from;
  const glm::dvec3 normal = glm::cross(mesh.points[triangle[1]] - mesh.points[triangle[0]],
                                       mesh.points[triangle[2]] - mesh.points[triangle[0]]);
  const double area = glm::length(normal);
  if (!(area > 0.0)) return false;
  const double reach = glm::length(glm::cross(to, edge));
  return glm::dot(to, normal) / area > 8.0 * rounding * (1.0 + reach / area);
}

bool turns_inwards_somewhere(const WeldedMesh& mesh, const Edges& edges, double rounding) {
  return std::ranges::any_of(edges, [&](const auto& entry) {
    const auto& [ends, edge] = entry;
    const Triangle &one = mesh.triangles[edge.along[0]], &other = mesh.triangles[edge.against[0]];
    return turns_inwards(mesh, one, other, ends.first, ends.second, rounding)
           || turns_inwards(mesh, other, one, ends.first, ends.second, rounding);
  });
}

// Does a point lie before the plane of any triangle? Where coordinates are coarse, no edge of a fine mesh tells a dent from
// rounding, but what lies on the far side of the dent does. Of large meshes every n-th triangle and point are looked
// at: a dent has many of both.
bool sticks_out_somewhere(const WeldedMesh& mesh, double rounding) {
  constexpr double patience = 4e7; // about .1 s
  const double pairs =
      static_cast<double>(mesh.triangles.size()) * static_cast<double>(mesh.points.size());
  const auto step = static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(pairs / patience))));
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const auto plane = plane_of(mesh, mesh.triangles[t]);
    if (!plane) continue;
    for (std::size_t i = 0; i < mesh.points.size(); i += step) {
      const glm::dvec3 to = mesh.points[i] - plane->through;
      const double before = glm::dot(to, plane->normal);
      if (before > 0.0 && before > 8.0 * rounding * (1.0 + glm::length(to) / plane->height))
        return true;
    }
  }
  return false;
}

bool is_convex(const WeldedMesh& mesh, const Edges& edges) {
  // More than two triangles at an edge: bodies that touch.
  if (!std::ranges::all_of(edges, [](const auto& e) { return e.second.along.size() == 1; }))
    return false;
  if (!in_one_piece(mesh)) return false;
  if (!turns_inwards_somewhere(mesh, edges, 0x1p-24 * mesh.largest)) return true;
  // Rounded to whole steps, a coordinate is off by half of one.
  const double coarse = 0.5 * coarsest_quantum * mesh.size;
  return !turns_inwards_somewhere(mesh, edges, coarse) && !sticks_out_somewhere(mesh, coarse);
}

bool is_planar(const WeldedMesh& mesh) {
  glm::dvec3 normal(0.0), through(0.0); // of the largest triangle
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 from = mesh.points[a];
    const glm::dvec3 n = glm::cross(mesh.points[b] - from, mesh.points[c] - from);
    if (glm::dot(n, n) > glm::dot(normal, normal)) normal = n, through = from;
  }
  const double length = glm::length(normal);
  // Flat to a hundred-thousandth of its size: float32 vertices of a turned plane are within a tenth of that.
  return length > 0.0 && std::ranges::all_of(mesh.points, [&](const glm::dvec3& p) {
           return std::abs(glm::dot(p - through, normal)) <= 1e-5 * mesh.size * length;
         });
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
  const WeldedMesh mesh = weld(scene, parts);
  if (mesh.triangles.empty()) return shape;
  shape.flat = is_flat(scene, parts);
  shape.planar = is_planar(mesh);
  const Edges edges = edges_of(mesh);
  shape.closed = std::ranges::none_of(edges, [](const auto& e) { return e.second.is_open(); });
  shape.convex = shape.closed && is_convex(mesh, edges);
  return shape;
}

} // namespace gg::scene
