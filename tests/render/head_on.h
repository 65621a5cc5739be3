// A square of shapes.h that the camera looks at squarely, in pictures of 64 x 64 pixels.
#pragma once

#include "render/harness.h"
#include "render/shapes.h"

namespace gg::test {

inline constexpr int head_on_size = 64;

inline frame::FrameDesc head_on() {
  return {
      .width = head_on_size, .height = head_on_size, .samples = 1, .camera = camera_at({0, 0, 2})};
}

// Where the pixel's centre meets the plane z = 0.
inline glm::dvec3 on_square(int x, int y) {
  const glm::dvec3 d = view_direction(head_on().camera, head_on_size, head_on_size, x, y);
  return glm::dvec3(0, 0, 2) - d * (2.0 / d.z);
}

} // namespace gg::test
