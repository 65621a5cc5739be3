#include "interior/walk.h"

#include "glsl/f64.h"
#include "truth/camera.h"
#include "truth/geometry.h"
#include "truth/surface.h"

namespace gg::test {
namespace {

using glsl::f64::reflectAbout;
using glsl::f64::refractAbout;
using truth::Hit;

constexpr int most_reflections = 8;

// The next place where the ray has left all bodies: how many it is in is counted.
std::optional<Hit> way_out(const truth::Geometry& geometry, truth::Ray ray) {
  for (int depth = 1;;) {
    const std::optional<Hit> hit = geometry.intersect(ray);
    if (!hit) return std::nullopt;
    depth += glm::dot(ray.direction, hit->normal) < 0.0 ? 1 : -1;
    if (depth == 0) return hit;
    ray.origin = geometry.leave(*hit, ray.direction);
  }
}

// Refracted out of the side of `outward`, or reflected; which of the two is told by the direction.
glm::dvec3 leave_or_return(const glm::dvec3& d, const glm::dvec3& shading,
                           const glm::dvec3& outward, double ior) {
  for (const glm::dvec3& n : {shading, outward}) {
    glm::dvec3 out = refractAbout(-d, n, 1.0 / ior);
    const bool refracted = out != glm::dvec3(0.0);
    if (!refracted) out = reflectAbout(-d, n);
    if ((glm::dot(out, outward) > 0.0) == refracted) return out;
  }
  return reflectAbout(-d, outward);
}

Walk follow(const truth::Geometry& geometry, const truth::Surfaces& surfaces, truth::Ray ray) {
  Walk result;
  const std::optional<Hit> entry = geometry.intersect(ray);
  if (!entry || glm::dot(entry->normal, ray.direction) >= 0.0) return result;
  const double ior = static_cast<double>(entry->part->material->ior);
  glm::dvec3 d = refractAbout(-ray.direction, surfaces.read(*entry, -ray.direction).n, ior);
  if (glm::dot(d, entry->normal) >= 0.0) d = refractAbout(-ray.direction, entry->normal, ior);
  Hit at = *entry;
  for (int k = 0; k <= most_reflections; ++k) {
    const auto hit = way_out(geometry, {geometry.leave(at, d), d});
    if (!hit) {
      result.fate = Fate::leaks;
      return result;
    }
    result.met.push_back(hit->position);
    d = leave_or_return(d, surfaces.read(*hit, -d).n, hit->normal, ior);
    if (glm::dot(d, hit->normal) > 0.0) {
      result.fate = Fate::leaves;
      result.reflections = k;
      result.direction = glm::normalize(d);
      return result;
    }
    at = *hit;
  }
  result.fate = Fate::trapped;
  return result;
}

} // namespace

std::vector<Walk> walk(const scene::Scene& scene, const scene::Camera& camera, int width,
                       int height) {
  const truth::Geometry geometry(scene);
  const truth::Surfaces surfaces(scene);
  const truth::Camera eye(camera, width, height);
  std::vector<Walk> walks;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      walks.push_back(follow(geometry, surfaces, eye.through(x + 0.5, y + 0.5)));
  return walks;
}

} // namespace gg::test
