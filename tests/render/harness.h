// Drawing in tests: one device for all tests of a process, its driver's messages turned into
// errors.
#pragma once

#include "environment/map.h"
#include "frame/renderer.h"
#include "gpu/device.h"
#include "image/image.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

namespace gg::test {

// Tests of pictures run on every backend: TEST_P(Render, ...).
struct Backend {
  const char* name;
  gpu::Backend backend;
  gpu::Surface surface;
};

class Render : public ::testing::TestWithParam<Backend> {
protected:
  gpu::Device& device() const;

  struct Setup {
    std::optional<environment::Map> environment;
    frame::FrameDesc desc; // its environment's stack is filled in
  };
  // With the environment's stack: until the next is asked for, or the test ends.
  frame::FrameDesc lit(const Setup& setup) const;
  // Draws and reads back; every picture is scanned for NaN and Inf on the way.
  image::Image draw(const scene::Scene& scene, Setup setup) const;
};

// An environment from a function of the direction (unit), as an equirectangular picture of width x
// width / 2.
environment::Map environment_of(int width, const std::function<glm::dvec3(glm::dvec3)>& radiance);

// The world direction in which the centre of pixel (x, y) looks, from the camera's own definition
// (glTF 2.0, 3.10).
glm::dvec3 view_direction(const scene::Camera& camera, int width, int height, double x, double y);

// Where the ray from `from` along the unit `direction` first meets the unit ball at the origin, if
// it does.
std::optional<glm::dvec3> hit_ball(glm::dvec3 from, glm::dvec3 direction);

glm::dvec3 rgb(const image::Image& picture, int x, int y);

} // namespace gg::test
