#include "scene/origin.h"

#include <map>

namespace gg::scene {
namespace {

constexpr float far_off = 16.0f; // radii: four bits of a coordinate

Bounds bounds_of(const Mesh& mesh) {
  Bounds bounds;
  for (const Primitive& p : mesh.primitives)
    if (!p.bounds.empty()) bounds.include(p.bounds.low), bounds.include(p.bounds.high);
  return bounds;
}

// The middles of the meshes that lie far from their origins; 0 for the others. Their positions are moved by as much.
std::vector<glm::vec3> recentre(Scene& scene) {
  std::vector<glm::vec3> centres(scene.meshes.size(), glm::vec3(0.0f));
  // A stream may serve several meshes, which are moved differently or not at all.
  std::map<std::pair<Index, std::size_t>, Index> moved;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const Bounds bounds = bounds_of(scene.meshes[m]);
    if (bounds.empty() || glm::length(bounds.centre()) <= far_off * bounds.radius()) continue;
    const glm::vec3 centre = centres[m] = bounds.centre();
    for (Primitive& p : scene.meshes[m].primitives) {
      const auto [at, is_new] = moved.try_emplace({p.positions, m}, none);
      if (is_new) {
        Stream stream = scene.streams[static_cast<std::size_t>(p.positions)];
        for (std::size_t i = 0; i < stream.values.size(); ++i)
          stream.values[i] -= centre[static_cast<int>(i % 3)]; // exact where the two are alike
        at->second = static_cast<Index>(scene.streams.size());
        scene.streams.push_back(std::move(stream));
      }
      p.positions = at->second;
      if (!p.bounds.empty()) p.bounds.low -= centre, p.bounds.high -= centre;
    }
  }
  return centres;
}

} // namespace

void move_origin(Scene& scene, const glm::vec3& origin) {
  const std::vector<glm::vec3> centres = recentre(scene);
  for (Instance& instance : scene.instances) {
    const glm::dmat4 world(instance.world);
    const glm::dvec4 centre(centres[static_cast<std::size_t>(instance.mesh)], 1.0);
    instance.world[3] = glm::vec4(world * centre - glm::dvec4(origin, 0.0));
  }
  for (Light& light : scene.lights)
    light.position -= origin;
  for (Camera& camera : scene.cameras)
    camera.world[3] -= glm::vec4(origin, 0.0f);
  if (!scene.bounds.empty()) scene.bounds.low -= origin, scene.bounds.high -= origin;
}

void move_origin_to(Camera& camera, Scene& scene) {
  move_origin(scene, camera.world[3]);
  camera.world[3] = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

} // namespace gg::scene
