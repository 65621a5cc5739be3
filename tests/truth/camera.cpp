// Rays go through the points of the picture where the raster's matrices put what they meet.
#include "truth/camera.h"

#include "uniforms/camera.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace {

using namespace gg;

void expect_same_pixels(const scene::Camera& view) {
  constexpr int width = 320, height = 180;
  // The camera's matrix is of float32, and not exactly orthonormal after a rotation: the raster
  // inverts it, a ray uses its columns. In pixels:
  constexpr double rounding = 320 * 2e-6;
  const truth::Camera camera(view, width, height);
  const glm::dmat4 clip_from_world =
      uniforms::clip_from_view(view, static_cast<double>(width) / height)
      * uniforms::view_from_world(view);
  for (const double x : {0.0, 17.25, 160.0, 320.0})
    for (const double y : {0.0, 91.5, 180.0}) {
      const truth::Ray ray = camera.through(x, y);
      EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
      for (const double t : {ray.near, 0.5 * (ray.near + ray.far), ray.far}) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(ray.origin + t * ray.direction, 1.0);
        EXPECT_NEAR(0.5 * (clip.x / clip.w + 1.0) * width, x, rounding);
        EXPECT_NEAR(0.5 * (1.0 - clip.y / clip.w) * height, y, rounding);
      }
      // Reversed depth: 1 at the near plane, 0 at the far one.
      const auto depth = [&](double t) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(ray.origin + t * ray.direction, 1.0);
        return clip.z / clip.w;
      };
      EXPECT_NEAR(depth(ray.near), 1.0, 1e-5);
      EXPECT_NEAR(depth(ray.far), 0.0, 1e-5);
    }
}

scene::Camera somewhere() {
  scene::Camera camera;
  camera.world = glm::rotate(glm::translate(glm::mat4(1.0f), {1.0f, -2.0f, 3.0f}), 0.7f,
                             glm::normalize(glm::vec3(1.0f, 2.0f, -0.5f)));
  camera.fovy = 0.6f;
  camera.near = 0.25f;
  camera.far = 40.0f;
  return camera;
}

TEST(truth_camera, perspective_rays_meet_the_rasters_pixels) {
  expect_same_pixels(somewhere());
}

TEST(truth_camera, orthographic_rays_meet_the_rasters_pixels) {
  scene::Camera camera = somewhere();
  camera.orthographic = true;
  camera.magnification = {5.0f, 2.0f};
  expect_same_pixels(camera);
}

} // namespace
