#include "uniforms/camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>

namespace gg::uniforms {

glm::dmat4 clip_from_view(const scene::Camera& camera, double aspect) {
  glm::dmat4 m(0.0);
  const double near = camera.near, far = camera.far;
  if (camera.orthographic) {
    // The vertical extent is kept, the horizontal one follows the picture's shape.
    m[0][0] = 1.0 / (camera.magnification.y * aspect);
    m[1][1] = 1.0 / camera.magnification.y;
    m[2][2] = 1.0 / (far - near);
    m[3][2] = far / (far - near);
    m[3][3] = 1.0;
    return m;
  }
  const double cot = 1.0 / std::tan(0.5 * static_cast<double>(camera.fovy));
  m[0][0] = cot / aspect;
  m[1][1] = cot;
  m[2][3] = -1.0;
  if (far > near) {
    m[2][2] = near / (far - near);
    m[3][2] = near * far / (far - near);
  } else {
    m[3][2] = near;
  }
  return m;
}

glm::dmat4 view_from_world(const scene::Camera& camera) {
  return glm::inverse(glm::dmat4(camera.world));
}

glm::dmat4 offset_by_pixels(double x, double y, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(-2.0 * x / width, 2.0 * y / height, 0.0));
}

glm::dvec2 sample_position(int i, int count) {
  if (count <= 1) return {0.0, 0.0};
  std::uint32_t bits = static_cast<std::uint32_t>(i), reversed = 0;
  for (int b = 0; b < 32; ++b, bits >>= 1)
    reversed = (reversed << 1) | (bits & 1u);
  const double radical_inverse = reversed * 0x1p-32;
  // For count a power of two the radical inverses are k / count, so half a step centres them; for
  // others the mean is within 1 / (2 count) of it.
  return {(i + 0.5) / count - 0.5, radical_inverse + 0.5 / count - 0.5};
}

} // namespace gg::uniforms
