// What is under the cursor.
#pragma once

#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>

namespace gg::viewer {

struct Ray {
  glm::vec3 origin{0.0f}, direction{0.0f, 0.0f, -1.0f};
};
// Through a point of the picture, in 0..1 from its top left.
Ray ray_through(const scene::Camera& camera, const glm::vec2& point, float aspect);

struct Picked {
  scene::Index instance = scene::none, primitive = scene::none, material = scene::none;
  float distance = 0.0f;
  glm::vec3 position{0.0f}, normal{0.0f};  // of the triangle, towards its front
  std::array<std::uint32_t, 3> vertices{}; // of the triangle, in the primitive's streams
  glm::vec3 weights{0.0f};                 // of these: barycentric
};
struct Sought {
  scene::Index instance = scene::none; // of this one alone
  bool back_faces = false; // triangles seen from behind, instead of those that the picture shows
};
// The nearest triangle along the ray, culled as the picture culls. Looks at every triangle of the boxes that it meets: some
// milliseconds for a million.
std::optional<Picked> pick(const scene::Scene& scene, const Ray& ray, const Sought& sought = {});

// Of one instance, in the world.
scene::Bounds bounds_of(const scene::Scene& scene, scene::Index instance);

} // namespace gg::viewer
