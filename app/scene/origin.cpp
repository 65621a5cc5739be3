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

Origin::Origin(Scene& scene) : scene_(scene), bounds_(scene.bounds) {
  const std::vector<glm::vec3> centres = recentre(scene);
  for (const Instance& instance : scene.instances)
    instances_.push_back(glm::dmat4(instance.world)
                         * glm::dvec4(centres[static_cast<std::size_t>(instance.mesh)], 1.0));
  for (const Light& light : scene.lights)
    lights_.push_back(light.position);
  for (const Camera& camera : scene.cameras)
    cameras_.push_back(camera.world[3]);
}

void Origin::move_to(const glm::vec3& origin) {
  for (std::size_t i = 0; i < instances_.size(); ++i)
    scene_.instances[i].world[3] = glm::vec4(instances_[i] - glm::dvec4(origin, 0.0));
  for (std::size_t i = 0; i < lights_.size(); ++i)
    scene_.lights[i].position = lights_[i] - origin;
  for (std::size_t i = 0; i < cameras_.size(); ++i)
    scene_.cameras[i].world[3] = cameras_[i] - glm::vec4(origin, 0.0f);
  scene_.bounds = bounds_;
  if (!bounds_.empty()) scene_.bounds.low -= origin, scene_.bounds.high -= origin;
}

void move_origin(Scene& scene, const glm::vec3& origin) {
  Origin(scene).move_to(origin);
}

void move_origin_to(Camera& camera, Scene& scene) {
  move_origin(scene, camera.world[3]);
  camera.world[3] = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

} // namespace gg::scene
