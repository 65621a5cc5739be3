#include "truth/camera.h"

#include <cmath>

namespace gg::truth {

Camera::Camera(const scene::Camera& camera, int width, int height)
    : right_(camera.world[0]), up_(camera.world[1]), back_(camera.world[2]), eye_(camera.world[3]),
      width_(width), height_(height), near_(camera.near),
      far_(camera.far > camera.near ? static_cast<double>(camera.far) : INFINITY),
      orthographic_(camera.orthographic) {
  const double half_height = orthographic_ ? static_cast<double>(camera.magnification.y)
                                           : std::tan(0.5 * static_cast<double>(camera.fovy));
  half_extent_ = {half_height * width_ / height_, half_height};
}

Ray Camera::through(double x, double y) const {
  const glm::dvec2 at = half_extent_ * glm::dvec2(2.0 * x / width_ - 1.0, 1.0 - 2.0 * y / height_);
  const glm::dvec3 across = at.x * right_ + at.y * up_;
  if (orthographic_) return {eye_ + across, -glm::normalize(back_), near_, far_};
  const glm::dvec3 direction = across - back_;
  // Near and far are planes: distances along the axis, longer along a ray aslant.
  const double length = glm::length(direction);
  return {eye_, direction / length, near_ * length, far_ * length};
}

} // namespace gg::truth
