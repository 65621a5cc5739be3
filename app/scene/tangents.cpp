#include "scene/tangents.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace gg::scene {
namespace {

using Id = std::uint32_t;
constexpr Id nobody = ~Id{0};

struct Vertex {
  glm::vec3 position, normal;
  glm::vec2 uv; // v upwards: negated, which unlike 1 - v loses no digits
  bool operator==(const Vertex&) const = default;
};

struct VertexHash {
  std::size_t operator()(const Vertex& v) const {
    std::array<float, 8> k{v.position.x, v.position.y, v.position.z, v.normal.x,
                           v.normal.y,   v.normal.z,   v.uv.x,       v.uv.y};
    for (float& x : k)
      x += 0.0f; // -0 equals 0, so it must hash alike
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(k.data()), sizeof k});
  }
};

// The derivative of position along u of one triangle, and on which side its texture faces.
struct Face {
  std::array<Id, 3> vertex{}; // after welding
  glm::vec3 along_u{0.0f};
  bool preserving = false; // the texture is not mirrored
  bool has_uv_area = false;
  bool degenerate = false; // two corners coincide
};

// Disjoint sets of corners: those that share one tangent.
class Groups {
public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Id{0}); }
  Id find(Id a) {
    while (parent_[a] != a)
      a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(Id a, Id b) { parent_[find(a)] = find(b); }

private:
  std::vector<Id> parent_;
};

class Mikk {
public:
  Mikk(std::span<const float> positions, std::span<const float> normals, std::span<const float> uvs,
       std::span<const Id> indices)
      : faces_(indices.size() / 3), groups_(indices.size()) {
    weld(positions, normals, uvs, indices);
    for (Face& face : faces_)
      derive(face);
    connect();
  }

  std::vector<glm::vec4> tangents() {
    std::vector<glm::vec3> sum(3 * faces_.size(), glm::vec3(0.0f));
    for (Id corner = 0; corner < sum.size(); ++corner)
      if (faces_[corner / 3].has_uv_area && !faces_[corner / 3].degenerate)
        sum[groups_.find(corner)] += contribution(corner);
    lend_to_degenerate();

    std::vector<glm::vec4> result(sum.size());
    for (Id corner = 0; corner < sum.size(); ++corner) {
      const Id from = lender_.empty() || lender_[corner] == nobody ? corner : lender_[corner];
      const Id group = groups_.find(from);
      const float length = glm::length(sum[group]);
      const glm::vec3 n = vertices_[faces_[corner / 3].vertex[corner % 3]].normal;
      result[corner] = length > 0.0f ? glm::vec4(sum[group] / length, orientation(group))
                                     : glm::vec4(perpendicular(n), 1.0f);
    }
    return result;
  }

private:
  // Corners that agree in position, normal and texture coordinates are one vertex, whatever the
  // file's indices say: the definition does not depend on how a mesh is indexed.
  void weld(std::span<const float> positions, std::span<const float> normals,
            std::span<const float> uvs, std::span<const Id> indices) {
    std::unordered_map<Vertex, Id, VertexHash> known;
    std::unordered_map<Id, Id> welded; // file's index -> vertex
    for (std::size_t corner = 0; corner < indices.size(); ++corner) {
      const Id i = indices[corner];
      auto place = welded.find(i);
      if (place == welded.end()) {
        const Vertex v{glm::make_vec3(positions.data() + 3 * std::size_t{i}),
                       glm::make_vec3(normals.data() + 3 * std::size_t{i}),
                       {uvs[2 * std::size_t{i}], -uvs[2 * std::size_t{i} + 1]}};
        const auto [found, is_new] = known.emplace(v, static_cast<Id>(vertices_.size()));
        if (is_new) vertices_.push_back(v);
        place = welded.emplace(i, found->second).first;
      }
      faces_[corner / 3].vertex[corner % 3] = place->second;
    }
  }

  // §3.7: solve the two edges for dP/du; its direction is all that is used.
  void derive(Face& face) const {
    const Vertex &a = vertices_[face.vertex[0]], &b = vertices_[face.vertex[1]],
                 &c = vertices_[face.vertex[2]];
    face.degenerate =
        a.position == b.position || b.position == c.position || c.position == a.position;
    const glm::vec2 tb = b.uv - a.uv, tc = c.uv - a.uv;
    const float area = tb.x * tc.y - tb.y * tc.x;
    face.preserving = area > 0.0f;
    const glm::vec3 du = tc.y * (b.position - a.position) - tb.y * (c.position - a.position);
    const float length = glm::length(du);
    face.has_uv_area = std::abs(area) > 0.0f && length > 0.0f && std::isfinite(length);
    if (face.has_uv_area) face.along_u = (face.preserving ? 1.0f : -1.0f) / length * du;
  }

  // §3.8: around a vertex, triangles that share an edge and face the texture the same way share a
  // tangent. Each side of an edge has one triangle; surplus ones of a non-manifold edge pair up in
  // file order. Triangles without texture area join whichever neighbour comes first.
  void connect() {
    struct Side {
      Id face, edge;
    };
    std::map<std::pair<Id, Id>, std::vector<Side>> open;
    std::vector<std::array<Side, 2>> shared;
    for (Id f = 0; f < faces_.size(); ++f) {
      if (faces_[f].degenerate) continue;
      for (Id e = 0; e < 3; ++e) {
        const Id from = faces_[f].vertex[e], to = faces_[f].vertex[(e + 1) % 3];
        const auto opposite = open.find({to, from});
        if (opposite != open.end() && !opposite->second.empty()) {
          shared.push_back({opposite->second.front(), Side{f, e}});
          opposite->second.erase(opposite->second.begin());
        } else {
          open[{from, to}].push_back({f, e});
        }
      }
    }
    std::vector<bool> adopted(faces_.size(), false);
    for (const bool regular : {true, false})
      for (const auto& [a, b] : shared) {
        const Face &fa = faces_[a.face], &fb = faces_[b.face];
        if (regular != (fa.has_uv_area && fb.has_uv_area)) continue;
        if (regular ? fa.preserving != fb.preserving : !adopt(a.face, b.face, adopted)) continue;
        groups_.join(3 * a.face + a.edge, 3 * b.face + (b.edge + 1) % 3);
        groups_.join(3 * a.face + (a.edge + 1) % 3, 3 * b.face + b.edge);
      }
  }

  // Lets the one of two faces that has no texture area take the other's side, once.
  bool adopt(Id a, Id b, std::vector<bool>& adopted) {
    if (!faces_[a].has_uv_area) std::swap(a, b);
    if (!faces_[a].has_uv_area) return false;
    if (adopted[b]) return faces_[b].preserving == faces_[a].preserving;
    adopted[b] = true;
    faces_[b].preserving = faces_[a].preserving;
    return true;
  }

  // §3.9: a triangle counts by its angle at the vertex, measured in the plane of the normal.
  glm::vec3 contribution(Id corner) const {
    const Face& face = faces_[corner / 3];
    const auto vertex = [&](Id k) -> const Vertex& { return vertices_[face.vertex[k % 3]]; };
    const Vertex& here = vertex(corner);
    const auto in_plane = [&](const glm::vec3& v) {
      const glm::vec3 p = v - glm::dot(here.normal, v) * here.normal;
      const float length = glm::length(p);
      return length > 0.0f ? p / length : glm::vec3(0.0f);
    };
    const glm::vec3 next = in_plane(vertex(corner % 3 + 1).position - here.position);
    const glm::vec3 previous = in_plane(vertex(corner % 3 + 2).position - here.position);
    const float angle = std::acos(std::clamp(glm::dot(next, previous), -1.0f, 1.0f));
    return angle * in_plane(face.along_u);
  }

  float orientation(Id corner) const { return faces_[corner / 3].preserving ? 1.0f : -1.0f; }

  // A triangle with coinciding corners takes part in nothing and is given the tangent of another
  // one at the same vertex.
  void lend_to_degenerate() {
    if (std::none_of(faces_.begin(), faces_.end(), [](const Face& f) { return f.degenerate; }))
      return;
    std::vector<Id> first(vertices_.size(), nobody);
    for (Id corner = 0; corner < 3 * faces_.size(); ++corner)
      if (const Face& f = faces_[corner / 3];
          !f.degenerate && first[f.vertex[corner % 3]] == nobody)
        first[f.vertex[corner % 3]] = corner;
    lender_.assign(3 * faces_.size(), nobody);
    for (Id corner = 0; corner < lender_.size(); ++corner)
      if (faces_[corner / 3].degenerate)
        lender_[corner] = first[faces_[corner / 3].vertex[corner % 3]];
  }

  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  Groups groups_; // over corners: 3 * face + corner
  std::vector<Id> lender_;
};

} // namespace

glm::vec3 perpendicular(const glm::vec3& n) {
  const glm::vec3 axis = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 p = axis - glm::dot(axis, n) * n;
  return p / glm::length(p);
}

std::vector<glm::vec4> corner_tangents(std::span<const float> positions,
                                       std::span<const float> normals, std::span<const float> uvs,
                                       std::span<const std::uint32_t> indices) {
  return Mikk(positions, normals, uvs, indices).tangents();
}

Split split_vertices(std::span<const std::uint32_t> indices, std::span<const glm::vec4> tangents) {
  Split split;
  split.indices.reserve(indices.size());
  // The versions of each old vertex form a chain; nearly all have one or two.
  std::unordered_map<std::uint32_t, std::uint32_t> first;
  std::vector<std::uint32_t> next;
  for (std::size_t corner = 0; corner < indices.size(); ++corner) {
    const glm::vec4& t = tangents[corner];
    const auto [place, is_new] =
        first.emplace(indices[corner], static_cast<std::uint32_t>(split.source.size()));
    std::uint32_t id = is_new ? nobody : place->second, last = nobody;
    while (id != nobody && glm::make_vec4(split.tangents.data() + 4 * std::size_t{id}) != t)
      last = std::exchange(id, next[id]);
    if (id == nobody) {
      id = static_cast<std::uint32_t>(split.source.size());
      if (last != nobody) next[last] = id;
      split.source.push_back(indices[corner]);
      split.tangents.insert(split.tangents.end(), {t.x, t.y, t.z, t.w});
      next.push_back(nobody);
    }
    split.indices.push_back(id);
  }
  return split;
}

} // namespace gg::scene
