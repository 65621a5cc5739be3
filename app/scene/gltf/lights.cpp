#include "scene/gltf/lights.h"

#include "scene/framing.h"
#include "scene/gltf/fail.h"
#include "scene/gltf/values.h"

#include <fmt/format.h>

#include <cmath>

namespace gg::scene::gltf {
namespace {

// The rotation and position of a transform: z is kept, y made perpendicular, x follows.
glm::mat4 rigid(const glm::mat4& m) {
  const auto unit = [](const glm::vec3& v, const glm::vec3& otherwise) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : otherwise;
  };
  const glm::vec3 z = unit(m[2], glm::vec3(0, 0, 1));
  const glm::vec3 side = unit(glm::cross(glm::vec3(m[1]), z), glm::vec3(1, 0, 0));
  const glm::vec3 x = unit(side - glm::dot(side, z) * z, glm::vec3(z.z, 0, -z.x));
  return {glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0), glm::vec4(z, 0), m[3]};
}

Camera camera_of(const Document& document, int index) {
  const auto& source = document.model().cameras[static_cast<std::size_t>(index)];
  Camera camera;
  camera.name = source.name;
  camera.fault = document.camera_fault(index);
  camera.orthographic = source.type == "orthographic";
  if (camera.orthographic) {
    const auto& o = source.orthographic;
    camera.magnification = glm::abs(glm::vec2(o.xmag, o.ymag));
    camera.near = static_cast<float>(o.znear);
    camera.far = static_cast<float>(o.zfar);
  } else {
    const auto& p = source.perspective;
    camera.fovy = static_cast<float>(p.yfov);
    camera.near = static_cast<float>(p.znear);
    camera.far = static_cast<float>(p.zfar);
    if (p.aspectRatio > 0.0) camera.aspect = static_cast<float>(p.aspectRatio);
  }
  return camera;
}

Light light_of(const Document& document, int index, const glm::mat4& world) {
  const auto& source = document.model().lights[static_cast<std::size_t>(index)];
  Light light;
  light.name = source.name;
  light.kind = source.type == "directional" ? LightKind::directional
               : source.type == "spot"      ? LightKind::spot
                                            : LightKind::point;
  light.intensity = static_cast<float>(source.intensity)
                    * (source.color.empty() ? glm::vec3(1.0f) : vector_of<3>(source.color));
  if (source.range > 0.0) light.range = static_cast<float>(source.range);
  if (light.kind == LightKind::spot) {
    light.inner_cone = static_cast<float>(source.spot.innerConeAngle);
    light.outer_cone = static_cast<float>(source.spot.outerConeAngle);
    const std::string place = fmt::format("extensions.KHR_lights_punctual.lights[{}].spot", index);
    if (light.inner_cone == light.outer_cone)
      note(document.name() + ": " + place + " has equal cones; its edge is sharp");
    if (light.inner_cone > light.outer_cone)
      fail(document.name(), place, "has an inner cone that is wider than the outer one");
  }
  light.position = world[3];
  light.direction = -glm::vec3(rigid(world)[2]);
  return light;
}

} // namespace

void read_cameras(const Document& document, const Hierarchy& hierarchy, Scene& scene) {
  for (const auto& [node, world] : hierarchy.placed()) {
    const tinygltf::Node& source = document.model().nodes[static_cast<std::size_t>(node)];
    if (source.camera < 0) continue;
    Camera camera = camera_of(document, source.camera);
    camera.world = rigid(world);
    if (!camera.orthographic && camera.near == 0.0f) {
      note(document.name() + ": " + element("cameras", source.camera)
           + ".perspective.znear is 0; set by what the camera sees");
      const float far = camera.far;
      fit_depth(camera, scene);
      camera.far = far;
    }
    if (!source.name.empty()) camera.name = source.name;
    scene.cameras.push_back(std::move(camera));
  }
}

void read_lights(const Document& document, const Hierarchy& hierarchy, Scene& scene) {
  for (const auto& [node, world] : hierarchy.placed()) {
    const tinygltf::Node& source = document.model().nodes[static_cast<std::size_t>(node)];
    const auto extension = source.extensions.find("KHR_lights_punctual");
    if (extension == source.extensions.end()) continue;
    Light light = light_of(document, integer_or(extension->second, "light", 0), world);
    if (light.name.empty()) light.name = source.name;
    scene.lights.push_back(std::move(light));
  }
}

} // namespace gg::scene::gltf
