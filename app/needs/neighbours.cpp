#include "needs/neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gg::needs {
namespace {

constexpr double in_plane = 1e-4; // of the size of what lies in a rectangle's plane: rounding

struct Candidate {
  std::uint32_t proxy;
  double importance; // steradians that it covers on average, about
  double distance;   // metres to its far end
};

double distance_to(const scene::Bounds& box, const glm::vec3& point) {
  const glm::vec3 nearest = glm::clamp(point, box.low, box.high);
  return glm::length(glm::dvec3(point) - glm::dvec3(nearest));
}

glm::vec3 corner_of(const scene::Bounds& box, unsigned i) {
  return {i & 1u ? box.high.x : box.low.x, i & 2u ? box.high.y : box.low.y,
          i & 4u ? box.high.z : box.low.z};
}

// The solid angle that a proxy covers, seen from points of a draw's box.
struct Cover {
  double area =
      0.0; // m²: of its shadow; 0: none of the points is on the side that is met, or all lie in its plane
  double range = 0.0;      // metres to it from where the box is nearest
  double at_most() const { // sr
    return 2.0 * std::numbers::pi * area / (area + 2.0 * std::numbers::pi * range * range);
  }
};

Cover cover_of(const scene::Bounds& box, const Proxy& proxy) {
  Cover cover;
  if (proxy.radius > 0.0f) {
    const double radius = static_cast<double>(proxy.radius);
    cover.area = std::numbers::pi * radius * radius;
    cover.range = std::max(distance_to(box, proxy.centre) - radius, 0.0);
    return cover;
  }
  const glm::dvec3 u(proxy.side_u), v(proxy.side_v);
  const glm::dvec3 n = glm::cross(u, v);
  const double quarter = glm::length(n);
  if (!(quarter > 0.0)) return cover;
  double highest = 0.0; // above its plane
  for (unsigned i = 0; i < 8; ++i) {
    const double height =
        glm::dot(n, glm::dvec3(corner_of(box, i)) - glm::dvec3(proxy.centre)) / quarter;
    highest = std::max(highest, proxy.one_sided ? height : std::abs(height));
  }
  if (!(highest > in_plane * static_cast<double>(box.radius()))) return cover;
  cover.area = 4.0 * quarter;
  cover.range = std::numeric_limits<double>::infinity();
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      cover.range = std::min(
          cover.range, distance_to(box, proxy.centre + 0.5f * static_cast<float>(i) * proxy.side_u
                                            + 0.5f * static_cast<float>(j) * proxy.side_v));
  return cover;
}

std::vector<std::uint32_t> neighbours_of(const Draw& draw, std::size_t body,
                                         const std::vector<Proxy>& proxies) {
  std::vector<Candidate> found;
  const glm::vec3 centre = draw.bounds.centre();
  const double size = static_cast<double>(draw.bounds.radius());
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    const Proxy& proxy = proxies[i];
    if (proxy.body == body) continue;
    const Cover cover = cover_of(draw.bounds, proxy);
    if (!(cover.at_most() > least_solid_angle)) continue;
    // A rectangle counts as far as it reaches: bodies on a floor hide it.
    const double reach = glm::length(glm::dvec3(proxy.side_u) + glm::dvec3(proxy.side_v));
    found.push_back({static_cast<std::uint32_t>(i),
                     cover.area / (cover.range * cover.range + size * size),
                     glm::length(glm::dvec3(proxy.centre - centre)) + reach});
  }
  std::ranges::stable_sort(found, std::greater{}, &Candidate::importance);
  found.resize(std::min(found.size(), most_neighbours));
  std::ranges::stable_sort(found, std::less{}, &Candidate::distance);
  // The faces of a body stay together.
  std::vector<std::uint32_t> list;
  for (const Candidate& candidate : found) {
    if (std::ranges::find(list, candidate.proxy) != list.end()) continue;
    for (const Candidate& other : found)
      if (proxies[other.proxy].body == proxies[candidate.proxy].body) list.push_back(other.proxy);
  }
  return list;
}

} // namespace

void find_neighbours(Draws& draws, const scene::Scene& scene, const Proxies& proxies) {
  for (Draw& draw : draws.all) {
    if (draw.material->unlit) continue;
    const auto own = proxies.bodies.find(place_in(scene, draws, draw));
    // What does not cast is no body.
    const std::size_t body =
        own == proxies.bodies.end() ? static_cast<std::size_t>(-1) : own->second;
    draw.neighbours = neighbours_of(draw, body, proxies.all);
    for (std::size_t i = 0; i < proxies.all.size(); ++i)
      if (proxies.all[i].body == body) {
        const bool alone = (i + 1 == proxies.all.size() || proxies.all[i + 1].body != body);
        if (alone) draw.own_proxy = static_cast<std::uint32_t>(i);
        break;
      }
    int kinds = 0;
    for (const std::uint32_t i : draw.neighbours) {
      kinds |= proxies.all[i].radius > 0.0f ? some_spheres : some_rectangles;
      const scene::Material& material = *proxies.all[i].material;
      if (is_refractive(material)) kinds |= some_glass;
      if (!is_refractive(material) || material.transmission < 1.0f || material.metallic > 0.0f)
        kinds |= some_opaque;
    }
    set_value(draw.key, Feature::neighbours, kinds);
    if (kinds != 0 && draw.own_proxy) // 1 a sphere, 2 a rectangle
      set_value(draw.key, Feature::own_proxy, proxies.all[*draw.own_proxy].radius > 0.0f ? 1 : 2);
  }
}

} // namespace gg::needs
