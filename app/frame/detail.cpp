#include "frame/detail.h"

#include <algorithm>
#include <cmath>

namespace gg::frame {
namespace {

// Where the bounds are nearest. Infinite if that is behind the eye.
double pixels_per_metre(const scene::Bounds& bounds, const needs::View& view) {
  const scene::Camera& camera = view.camera;
  if (camera.orthographic) return view.height / (2.0 * static_cast<double>(camera.magnification.y));
  const glm::vec3 forward(-camera.world[2]);
  const glm::vec3 towards_eye(forward.x > 0.0f ? bounds.low.x : bounds.high.x,
                              forward.y > 0.0f ? bounds.low.y : bounds.high.y,
                              forward.z > 0.0f ? bounds.low.z : bounds.high.z);
  const float nearest = glm::dot(towards_eye - glm::vec3(camera.world[3]), forward);
  if (!(nearest > 0.0f)) return INFINITY;
  return view.height
         / (2.0 * std::tan(0.5 * static_cast<double>(camera.fovy)) * static_cast<double>(nearest));
}

} // namespace

const scene::CoarseList* coarsest(const scene::CoarseLists& lists, const needs::Draw& draw,
                                  const scene::Instance& instance, const needs::View& view) {
  constexpr double seen = 0.5; // pixels
  const auto found = lists.find(draw.primitive->indices);
  if (found == lists.end()) return nullptr;
  float scale = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
    scale = std::max(scale, glm::length(glm::vec3(instance.world[axis])));
  const double pixels = pixels_per_metre(draw.bounds, view);
  const scene::CoarseList* enough = nullptr;
  for (const scene::CoarseList& list : found->second) // their errors rise
    if (static_cast<double>(scale * list.error) * pixels <= seen) enough = &list;
  return enough;
}

} // namespace gg::frame
