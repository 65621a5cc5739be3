#include "scene/framing.h"

#include "core/error.h"
#include "scene/nearest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gg::scene {
namespace {

constexpr float margin = 1.1f; // of the picture around the bounds

// What stands in for the bounds where there are none, or where all is one point.
Bounds usable(const Bounds& bounds) {
  if (!bounds.empty() && bounds.radius() > 0.0f) return bounds;
  const glm::vec3 centre = bounds.empty() ? glm::vec3(0.0f) : bounds.centre();
  Bounds sphere;
  sphere.include(centre - glm::vec3(1.0f));
  sphere.include(centre + glm::vec3(1.0f));
  return sphere;
}

std::string listing(const Scene& scene) {
  if (scene.cameras.empty())
    return "The file has no cameras: leave --camera out, or give --eye and --target.";
  std::string text = "The file has:";
  for (std::size_t i = 0; i < scene.cameras.size(); ++i)
    text += fmt::format("{} {} ({})", i ? "," : "", i,
                        scene.cameras[i].name.empty() ? "unnamed" : scene.cameras[i].name);
  return text + ".";
}

} // namespace

void fit_depth(Camera& camera, const Scene& scene) {
  const Bounds bounds = usable(scene.bounds);
  const float radius = bounds.radius();
  const glm::vec3 eye = camera.world[3], forward = -glm::vec3(camera.world[2]);
  const float depth = glm::dot(bounds.centre() - eye, forward);
  // From within the bounds: a thousandth of them, which float depth resolves (a ratio of about 4,000).
  camera.near = std::max(depth - margin * radius, 1e-3f * radius);
  constexpr float room = 0.9f; // for rounding, here and where vertices are transformed
  if (const float clear = clear_depth(scene, camera, camera.near); clear < camera.near)
    // Nearer than a millionth of the scene vertices are rounded in float32.
    camera.near = std::max(room * clear, 1e-6f * radius);
  camera.far = std::max(depth + margin * radius, 2.0f * camera.near);
}

const Camera& usable_camera(const Camera& camera) {
  if (!camera.fault.empty())
    throw Error(ExitCode::input, "", camera.fault,
                "Or give --eye and --target, or another --camera.");
  return camera;
}

Camera default_camera(const Scene& scene, float aspect) {
  const Bounds bounds = usable(scene.bounds);
  Camera camera;
  camera.name = "default";
  const glm::vec3 half = 0.5f * (bounds.high - bounds.low);
  // From the side that shows most: from +Z, unless the scene is flat and lies or stands edge-on to that. Twenty times thinner than
  // wide is no object but a floor, a wall or a picture.
  constexpr float flat = 0.05f;
  const float widest = std::max({half.x, half.y, half.z});
  const bool lies = half.y < flat * widest && half.y <= std::min(half.x, half.z);
  const bool stands = !lies && half.x < flat * widest && half.x <= half.z;
  // right, up, back, and the half-extents along them
  glm::mat3 axes(1.0f);
  if (lies) axes = glm::mat3(glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0, 1, 0));
  if (stands) axes = glm::mat3(glm::vec3(0, 0, -1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0));
  const glm::vec3 extent = glm::abs(glm::transpose(axes) * half);
  // The front face of the box is what fills most of the picture; its half-extents over the tangents
  // of the half-angles give the distance.
  const float tangent = std::tan(0.5f * camera.fovy);
  const float distance = margin * std::max(extent.y / tangent, extent.x / (tangent * aspect));
  const float least = 0.1f * bounds.radius(); // a line seen end-on has neither height nor width
  camera.world = glm::mat4(axes);
  camera.world[3] =
      glm::vec4(bounds.centre() + (extent.z + std::max(distance, least)) * axes[2], 1.0f);
  fit_depth(camera, scene);
  return camera;
}

Camera look_at(const Scene& scene, const glm::vec3& eye, const glm::vec3& target,
               const glm::vec3& up, float fovy) {
  const auto reject = [](const char* what, const char* remedy) {
    throw Error(ExitCode::usage, "camera", what, remedy);
  };
  // The largest number of a float has a square that is none: scale before taking lengths.
  const auto direction = [](const glm::vec3& v) {
    const glm::dvec3 d(v);
    const double length = glm::length(d);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(d / length) : glm::vec3(0.0f);
  };
  if (!(fovy > 0.0f && fovy < 3.14159265f)) reject("fovy is not between 0 and 180 degrees", "");
  const glm::vec3 z = direction(eye - target);
  if (z == glm::vec3(0.0f)) reject("eye and target are the same point", "Move one of them.");
  const glm::vec3 x = direction(glm::cross(direction(up), z));
  if (x == glm::vec3(0.0f)) reject("up points along the line of sight", "Choose another --up.");
  Camera camera;
  camera.name = "eye";
  camera.fovy = fovy;
  camera.world = {glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0), glm::vec4(z, 0),
                  glm::vec4(eye, 1)};
  fit_depth(camera, scene);
  return camera;
}

const Camera& find_camera(const Scene& scene, const std::string& wanted) {
  for (const Camera& camera : scene.cameras)
    if (camera.name == wanted) return usable_camera(camera);
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (error == std::errc() && end == wanted.data() + wanted.size() && index < scene.cameras.size())
    return usable_camera(scene.cameras[index]);
  throw Error(ExitCode::usage, scene.path, "has no camera '" + wanted + "'", listing(scene));
}

} // namespace gg::scene
