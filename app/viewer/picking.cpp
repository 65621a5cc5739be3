#include "viewer/picking.h"

#include <algorithm>
#include <cmath>

namespace gg::viewer {
namespace {

bool meets(const scene::Bounds& box, const Ray& ray, float nearest) {
  float from = 0.0f, to = nearest;
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = 1.0f / ray.direction[axis];
    float a = (box.low[axis] - ray.origin[axis]) * inverse;
    float b = (box.high[axis] - ray.origin[axis]) * inverse;
    if (a > b) std::swap(a, b);
    if (std::isnan(a) || std::isnan(b)) continue; // in the plane of a face: the other axes decide
    from = std::max(from, a);
    to = std::min(to, b);
  }
  return from <= to;
}

glm::vec3 vertex(const scene::Stream& stream, std::uint32_t i) {
  const float* v = &stream.values[3 * std::size_t{i}];
  return {v[0], v[1], v[2]};
}

// The distance, and the weights of b and c. Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
std::optional<glm::vec3> hit(const Ray& ray, const glm::vec3& a, const glm::vec3& b,
                             const glm::vec3& c) {
  const glm::vec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const float determinant = glm::dot(ab, p);
  if (determinant == 0.0f) return std::nullopt;
  const glm::vec3 from = ray.origin - a;
  const float u = glm::dot(from, p) / determinant;
  if (!(u >= 0.0f && u <= 1.0f)) return std::nullopt;
  const glm::vec3 q = glm::cross(from, ab);
  const float v = glm::dot(ray.direction, q) / determinant;
  if (!(v >= 0.0f && u + v <= 1.0f)) return std::nullopt;
  const float t = glm::dot(ac, q) / determinant;
  return t > 0.0f ? std::optional(glm::vec3(t, u, v)) : std::nullopt;
}

} // namespace

Ray ray_through(const scene::Camera& camera, const glm::vec2& point, float aspect) {
  const glm::vec3 x = camera.world[0], y = camera.world[1], z = camera.world[2],
                  eye = camera.world[3];
  const glm::vec2 clip(2.0f * point.x - 1.0f, 1.0f - 2.0f * point.y);
  if (camera.orthographic) {
    const glm::vec2 half(aspect * camera.magnification.y, camera.magnification.y);
    return {eye + clip.x * half.x * x + clip.y * half.y * y, -z};
  }
  const float tangent = std::tan(0.5f * camera.fovy);
  return {eye, glm::normalize(clip.x * tangent * aspect * x + clip.y * tangent * y - z)};
}

std::optional<Picked> pick(const scene::Scene& scene, const Ray& ray, const Sought& sought) {
  std::optional<Picked> nearest;
  float distance = INFINITY;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Instance& instance = scene.instances[i];
    if (sought.instance != scene::none && sought.instance != static_cast<scene::Index>(i)) continue;
    const glm::mat4 inverse = glm::inverse(instance.world);
    // The direction is not normalised: distances along it stay those of the world.
    const Ray local{glm::vec3(inverse * glm::vec4(ray.origin, 1.0f)),
                    glm::vec3(inverse * glm::vec4(ray.direction, 0.0f))};
    const auto& primitives = scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const scene::Primitive& primitive = primitives[p];
      if (!meets(primitive.bounds, local, distance)) continue;
      const scene::Material& material =
          scene.materials[static_cast<std::size_t>(primitive.material)];
      const scene::Stream& positions = scene.streams[static_cast<std::size_t>(primitive.positions)];
      const scene::Indices& indices = scene.indices[static_cast<std::size_t>(primitive.indices)];
      for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
        const glm::vec3 a = vertex(positions, indices[t]), b = vertex(positions, indices[t + 1]),
                        c = vertex(positions, indices[t + 2]);
        const auto at = hit(local, a, b, c);
        if (!at || at->x >= distance) continue;
        const glm::vec3 facing = glm::cross(b - a, c - a);
        const bool behind = glm::dot(facing, local.direction) > 0.0f;
        if (sought.back_faces ? !behind : behind && !material.double_sided) continue;
        distance = at->x;
        nearest =
            Picked{static_cast<scene::Index>(i),
                   static_cast<scene::Index>(p),
                   primitive.material,
                   distance,
                   ray.origin + distance * ray.direction,
                   glm::normalize(glm::vec3(glm::transpose(inverse) * glm::vec4(facing, 0.0f))),
                   {indices[t], indices[t + 1], indices[t + 2]},
                   {1.0f - at->y - at->z, at->y, at->z}};
      }
    }
  }
  return nearest;
}

scene::Bounds bounds_of(const scene::Scene& scene, scene::Index instance) {
  scene::Bounds bounds;
  const scene::Instance& placed = scene.instances[static_cast<std::size_t>(instance)];
  for (const scene::Primitive& primitive :
       scene.meshes[static_cast<std::size_t>(placed.mesh)].primitives)
    for (int corner = 0; corner < 8 && !primitive.bounds.empty(); ++corner) {
      const glm::vec3 at((corner & 1) ? primitive.bounds.high.x : primitive.bounds.low.x,
                         (corner & 2) ? primitive.bounds.high.y : primitive.bounds.low.y,
                         (corner & 4) ? primitive.bounds.high.z : primitive.bounds.low.z);
      bounds.include(glm::vec3(placed.world * glm::vec4(at, 1.0f)));
    }
  return bounds;
}

} // namespace gg::viewer
