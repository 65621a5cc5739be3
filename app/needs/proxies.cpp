#include "needs/proxies.h"

#include "needs/features.h"
#include "needs/flat.h"
#include "needs/shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace gg::needs {
namespace {

constexpr double thin = 0.02;   // the same of what is no rectangle but is taken for one
constexpr double filled = 0.02; // of an area: what may be missing, or lie double
constexpr double in_part =
    0.1; // of the lesser box: parts of one instance that share more of it are one body
constexpr double within = 0.8;  // the same of two instances
constexpr double is_long = 2.0; // times as long as wide: several spheres
constexpr double round = 0.02;  // of its radius: how far a ball's points may be off its sphere
constexpr int most_spheres = 4;
constexpr std::size_t most_merged =
    512; // parts, past which instances are not compared with each other

struct Part {
  std::size_t instance = 0, index = 0;
  const scene::Primitive* primitive = nullptr;
  const scene::Material* material = nullptr;
  glm::dmat4 world{1.0};
  scene::Bounds bounds; // world
  double area = 0.0;    // world, m²
};

class Triangles {
public:
  Triangles(const scene::Scene& scene, const Part& part)
      : values_(scene.streams[static_cast<std::size_t>(part.primitive->positions)].values),
        indices_(scene.indices[static_cast<std::size_t>(part.primitive->indices)]) {}
  std::size_t count() const { return indices_.size() / 3; }
  glm::dvec3 corner(std::size_t i) const {
    const std::size_t k = 3 * static_cast<std::size_t>(indices_[i]);
    return {values_[k], values_[k + 1], values_[k + 2]};
  }
  // Twice the area, along the normal.
  glm::dvec3 across(std::size_t t) const {
    return glm::cross(corner(3 * t + 1) - corner(3 * t), corner(3 * t + 2) - corner(3 * t));
  }

private:
  const std::vector<float>& values_;
  const scene::Indices& indices_;
};

glm::dvec3 in_world(const Part& part, const glm::dvec3& p) {
  return glm::dvec3(part.world * glm::dvec4(p, 1.0));
}

bool casts(const scene::Material& material, const scene::Primitive& primitive) {
  if (is_refractive(material)) return !is_invisible(material, primitive);
  return material.alpha_mode != scene::AlphaMode::blend;
}

std::vector<Part> parts_of(const scene::Scene& scene) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Instance& instance = scene.instances[i];
    const auto& primitives = scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const scene::Material& material =
          scene.materials[static_cast<std::size_t>(primitives[p].material)];
      if (primitives[p].bounds.empty() || !casts(material, primitives[p])) continue;
      Part part{.instance = i,
                .index = p,
                .primitive = &primitives[p],
                .material = &material,
                .world = glm::dmat4(instance.world)};
      for (unsigned k = 0; k < 8; ++k) {
        const scene::Bounds& box = primitives[p].bounds;
        part.bounds.include(glm::vec3(
            in_world(part, {k & 1u ? box.high.x : box.low.x, k & 2u ? box.high.y : box.low.y,
                            k & 4u ? box.high.z : box.low.z})));
      }
      const Triangles triangles(scene, part);
      for (std::size_t t = 0; t < triangles.count(); ++t)
        part.area +=
            0.5
            * glm::length(glm::cross(
                glm::dmat3(part.world) * (triangles.corner(3 * t + 1) - triangles.corner(3 * t)),
                glm::dmat3(part.world) * (triangles.corner(3 * t + 2) - triangles.corner(3 * t))));
      parts.push_back(part);
    }
  }
  return parts;
}

// The area of the part's triangles that lie in each face of its mesh's box (low and high of x, y, z), and of all; with the
// direction in which those of a face look.
struct BoxFaces {
  std::array<double, 6> area{};
  std::array<double, 6> outward{};
  double all = 0.0;
};

BoxFaces box_faces(const Triangles& triangles, const glm::dvec3& low, const glm::dvec3& high) {
  BoxFaces faces;
  // A flat body has no extent along an axis; its vertices lie on the face nevertheless.
  const glm::dvec3 close = flat_below * (high - low) + 1e-12;
  for (std::size_t t = 0; t < triangles.count(); ++t) {
    const glm::dvec3 across = triangles.across(t);
    const double area = 0.5 * glm::length(across);
    faces.all += area;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        const double plane = side ? high[axis] : low[axis];
        bool lies = true;
        for (std::size_t k = 0; k < 3; ++k)
          lies = lies && std::abs(triangles.corner(3 * t + k)[axis] - plane) <= close[axis];
        if (!lies) continue;
        const auto f = static_cast<std::size_t>(2 * axis + side);
        faces.area[f] += area;
        faces.outward[f] += across[axis] * (side ? 0.5 : -0.5);
      }
  }
  return faces;
}

Proxy rectangle(const Part& part, const glm::dvec3& centre, const glm::dvec3& u,
                const glm::dvec3& v) {
  return {.centre = glm::vec3(in_world(part, centre)),
          .side_u = glm::vec3(glm::dmat3(part.world) * u),
          .side_v = glm::vec3(glm::dmat3(part.world) * v),
          .material = part.material};
}

// What is flat along an axis of its mesh's box is one rectangle, of the same area; what fills the six faces of its box is these.
std::vector<Proxy> rectangles_of(const scene::Scene& scene, const Part& part) {
  const Triangles triangles(scene, part);
  const glm::dvec3 low(part.primitive->bounds.low), high(part.primitive->bounds.high);
  const glm::dvec3 size = high - low, centre = 0.5 * (low + high);
  const glm::dvec3 metres(glm::length(glm::dvec3(part.world[0])) * size.x,
                          glm::length(glm::dvec3(part.world[1])) * size.y,
                          glm::length(glm::dvec3(part.world[2])) * size.z);
  const int narrow = metres.x <= metres.y && metres.x <= metres.z ? 0
                     : metres.y <= metres.z                       ? 1
                                                                  : 2;
  const int a = (narrow + 1) % 3, b = (narrow + 2) % 3;
  const double front = size[a] * size[b];
  const auto half = [&](int axis) {
    glm::dvec3 side(0.0);
    side[axis] = 0.5 * size[axis];
    return side;
  };
  if (!(front > 0.0)) return {};
  const BoxFaces faces = box_faces(triangles, low, high);
  if (metres[narrow] <= thin * std::max(metres[a], metres[b])) {
    // A sheet has its area once, what is thick twice.
    const bool sheet = metres[narrow] <= flat_below * std::max(metres[a], metres[b]);
    const double across = metres[a] * metres[b];
    const double share = std::min(part.area / (sheet ? across : 2.0 * across), 1.0);
    const double shrink = share > 1.0 - filled ? 1.0 : std::sqrt(share);
    return {rectangle(part, centre, shrink * half(a), shrink * half(b))};
  }
  std::vector<Proxy> found;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto f = static_cast<std::size_t>(2 * axis + side);
      if (std::abs(faces.area[f] - size[u] * size[v]) > filled * size[u] * size[v]) return {};
      glm::dvec3 at = centre;
      at[axis] = side ? high[axis] : low[axis];
      // cross(u, v) is the axis: the front of a room's walls is inside.
      const bool turned = (side == 1) != (faces.outward[f] > 0.0);
      Proxy face = rectangle(part, at, half(u), (turned ? -1.0 : 1.0) * half(v));
      if (glm::determinant(glm::dmat3(part.world)) < 0.0) face.side_v = -face.side_v;
      face.one_sided = !part.material->double_sided;
      found.push_back(face);
    }
  const double six = std::accumulate(faces.area.begin(), faces.area.end(), 0.0);
  return faces.all - six > filled * faces.all ? std::vector<Proxy>{} : found;
}

double overlap(const scene::Bounds& a, const scene::Bounds& b) {
  const glm::dvec3 common = glm::max(
      glm::dvec3(glm::min(a.high, b.high)) - glm::dvec3(glm::max(a.low, b.low)), glm::dvec3(0.0));
  const auto volume = [](const glm::dvec3& size) { return size.x * size.y * size.z; };
  const double lesser = std::min(volume(glm::dvec3(a.high) - glm::dvec3(a.low)),
                                 volume(glm::dvec3(b.high) - glm::dvec3(b.low)));
  return lesser > 0.0 ? volume(common) / lesser : 0.0;
}

// Of each part the first part of the same body.
std::vector<std::size_t> bodies_of(const std::vector<Part>& parts,
                                   const std::vector<bool>& flat_part) {
  std::vector<std::size_t> first(parts.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (first[i] != i)
      i = first[i];
    return i;
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const bool same = parts[i].instance == parts[j].instance;
      if (!same && parts.size() > most_merged) break; // those of an instance stand together
      if (flat_part[i] || flat_part[j]) continue;
      if (overlap(parts[i].bounds, parts[j].bounds) > (same ? in_part : within)) {
        const auto [low, high] = std::minmax(root(i), root(j));
        first[high] = low;
      }
    }
  for (std::size_t i = 0; i < parts.size(); ++i)
    first[i] = root(i);
  return first;
}

// A sphere, or a row of them.
std::vector<Proxy> spheres_of(const scene::Scene& scene, const std::vector<const Part*>& parts) {
  std::vector<glm::dvec3> points;
  const scene::Material* material = nullptr;
  double largest = -1.0;
  for (const Part* part : parts) {
    const Triangles triangles(scene, *part);
    const std::size_t corners = 3 * triangles.count();
    const std::size_t step = std::max<std::size_t>(1, corners * parts.size() / most_shadow_points);
    for (std::size_t i = 0; i < corners; i += step)
      points.push_back(in_world(*part, triangles.corner(i)));
    if (part->area > largest) {
      largest = part->area;
      material = part->material;
    }
  }
  const MeanShadow shadow = mean_shadow(points);
  if (!(shadow.area > 0.0)) return {};
  const LongestAxis axis = longest_axis(points);
  const int count =
      axis.length > is_long * axis.width
          ? std::clamp(static_cast<int>(std::lround(axis.length / axis.width)), 2, most_spheres)
          : 1;
  const double radius = std::sqrt(shadow.area / (std::numbers::pi * count));
  const bool ball = count == 1 && std::ranges::all_of(points, [&](const glm::dvec3& p) {
                      return std::abs(glm::length(p - shadow.centre) - radius) < round * radius;
                    });
  std::vector<Proxy> spheres;
  for (int i = 0; i < count; ++i) {
    const double along = count == 1 ? 0.0 : ((i + 0.5) / count - 0.5) * axis.length;
    spheres.push_back({.centre = glm::vec3(shadow.centre + along * axis.direction),
                       .radius = static_cast<float>(radius),
                       .ball = ball,
                       .material = material});
  }
  return spheres;
}

} // namespace

bool is_lens(const Proxy& proxy) {
  return proxy.ball && is_refractive(*proxy.material) && proxy.material->thickness > 0.0f
         && proxy.material->ior > 1.0f;
}

Proxies proxies_of(const scene::Scene& scene) {
  const std::vector<Part> parts = parts_of(scene);
  Proxies proxies;
  std::vector<std::vector<Proxy>> rectangles;
  std::vector<bool> flat_part;
  for (const Part& part : parts) {
    rectangles.push_back(rectangles_of(scene, part));
    flat_part.push_back(!rectangles.back().empty());
  }
  const std::vector<std::size_t> first = bodies_of(parts, flat_part);
  std::vector<std::vector<const Part*>> parts_from(parts.size()); // of a body, by its first part
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts_from[first[i]].push_back(&parts[i]);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    proxies.bodies[{parts[i].instance, parts[i].index}] = first[i];
    if (first[i] != i) continue;
    for (Proxy& proxy : flat_part[i] ? rectangles[i] : spheres_of(scene, parts_from[i])) {
      proxy.body = i;
      proxies.all.push_back(proxy);
    }
  }
  return proxies;
}

} // namespace gg::needs
