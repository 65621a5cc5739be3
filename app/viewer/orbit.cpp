#include "viewer/orbit.h"

#include <algorithm>
#include <cmath>

namespace gg::viewer {
namespace {

constexpr float pi = 3.14159265f;

// x right, y up, z towards the eye.
struct Axes {
  glm::vec3 x, y, z;
};

Axes axes_of(const Place& place) {
  const glm::vec3 z = glm::normalize(place.eye - place.target);
  const glm::vec3 x = glm::normalize(glm::cross(place.up, z));
  return {x, glm::cross(z, x), z};
}

glm::vec3 turned(const glm::vec3& v, const glm::vec3& axis, float angle) {
  return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v)
         + (1.0f - std::cos(angle)) * glm::dot(axis, v) * axis;
}

// The height of the plane through the target that the picture shows.
float height_at_target(const Place& place) {
  if (place.ortho > 0.0f) return place.ortho;
  return 2.0f * std::tan(0.5f * glm::radians(place.fovy)) * glm::length(place.eye - place.target);
}

} // namespace

Place place_of(const scene::Camera& camera, const scene::Bounds& bounds) {
  const glm::vec3 eye = camera.world[3], forward = -glm::vec3(camera.world[2]);
  const glm::vec3 up = camera.world[1];
  const glm::vec3 centre = bounds.empty() ? eye + forward : bounds.centre();
  const float radius = bounds.empty() ? 1.0f : bounds.radius();
  float distance = std::max(glm::dot(centre - eye, forward), 0.05f * radius);
  if (!(distance > 0.0f)) distance = 1.0f;
  Place place{.eye = eye,
              .target = eye + distance * forward,
              .fovy = glm::degrees(camera.fovy),
              .ortho = camera.orthographic ? 2.0f * camera.magnification.y : 0.0f};
  // Level cameras turn about the vertical; tilted ones about their own up.
  const glm::vec3 right = camera.world[0];
  // Level to a milliradian, less than a pixel over the width of a window; not when it looks straight up or down.
  const bool level = std::abs(right.y) < 1e-3f && up.y > 0.0f && std::abs(forward.y) < 0.999f;
  place.up = level ? glm::vec3(0.0f, 1.0f, 0.0f) : up;
  return place;
}

void orbit(Place& place, float yaw, float pitch) {
  const glm::vec3 up = glm::normalize(place.up);
  glm::vec3 arm = turned(place.eye - place.target, up, yaw);
  const float length = glm::length(arm);
  // Half a degree from the poles, where `up` would be along the line of sight.
  constexpr float least = 0.5f * pi / 180.0f;
  const float polar = std::acos(std::clamp(glm::dot(arm / length, up), -1.0f, 1.0f));
  const float wanted = std::clamp(polar - pitch, least, pi - least);
  const glm::vec3 side = glm::cross(up, arm);
  if (glm::length(side) > 0.0f) arm = turned(arm, glm::normalize(side), wanted - polar);
  place.eye = place.target + length * glm::normalize(arm);
}

void pan(Place& place, const glm::vec2& heights) {
  const Axes axes = axes_of(place);
  const glm::vec3 move = height_at_target(place) * (-heights.x * axes.x + heights.y * axes.y);
  place.eye += move;
  place.target += move;
}

void dolly(Place& place, float factor, const glm::vec2& cursor, float radius) {
  const float distance = glm::length(place.eye - place.target);
  // From within a surface's detail to where the scene is less than a pixel.
  const float wanted = std::clamp(distance * factor, 1e-4f * radius, 1e4f * radius);
  const float real = wanted / distance;
  const Axes axes = axes_of(place);
  // The point under the cursor in the target's plane stays: the target moves towards it as the distance shrinks.
  const glm::vec3 point = height_at_target(place) * (cursor.x * axes.x - cursor.y * axes.y);
  place.target += (1.0f - real) * point;
  place.eye = place.target + wanted * axes.z;
  place.ortho *= real;
}

void set_orthographic(Place& place, bool on) {
  if (on == (place.ortho > 0.0f)) return;
  if (on) {
    place.ortho = height_at_target(place);
    return;
  }
  const glm::vec3 z = axes_of(place).z;
  place.eye = place.target + 0.5f * place.ortho / std::tan(0.5f * glm::radians(place.fovy)) * z;
  place.ortho = 0.0f;
}

void frame(Place& place, const scene::Bounds& bounds, float aspect) {
  if (bounds.empty()) return;
  const Axes axes = axes_of(place);
  // A point is framed as if it were a micrometre.
  const float radius = std::max(bounds.radius(), 1e-6f);
  // The sphere around the bounds fits the narrower angle.
  const float half = 0.5f * glm::radians(place.fovy);
  const float narrow = std::min(half, std::atan(std::tan(half) * aspect));
  place.target = bounds.centre();
  place.eye = place.target + (radius / std::sin(narrow)) * axes.z;
  if (place.ortho > 0.0f) place.ortho = 2.0f * radius / std::min(aspect, 1.0f);
}

void look_from(Place& place, Side side) {
  constexpr float tilt = 0.01f; // from the poles, for the line of sight may not be along `up`
  const float distance = glm::length(place.eye - place.target);
  glm::vec3 arm(0.0f, 0.0f, 1.0f);
  switch (side) {
  case Side::front:
    break;
  case Side::back:
    arm = {0.0f, 0.0f, -1.0f};
    break;
  case Side::right:
    arm = {1.0f, 0.0f, 0.0f};
    break;
  case Side::left:
    arm = {-1.0f, 0.0f, 0.0f};
    break;
  case Side::top:
    arm = glm::normalize(glm::vec3(0.0f, 1.0f, tilt));
    break;
  case Side::bottom:
    arm = glm::normalize(glm::vec3(0.0f, -1.0f, tilt));
    break;
  }
  place.up = {0.0f, 1.0f, 0.0f};
  place.eye = place.target + distance * arm;
}

} // namespace gg::viewer
