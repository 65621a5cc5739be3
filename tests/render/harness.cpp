#include "render/harness.h"

#include "environment/stack.h"
#include "support/devices.h"
#include "support/pictures.h"

#include <cmath>
#include <numbers>

namespace gg::test {
gpu::Device& Render::device() const {
  return shared_device(GetParam().backend, GetParam().surface);
}

image::Image Render::draw(const scene::Scene& scene, Setup setup) const {
  std::optional<environment::Stack> stack;
  if (setup.environment) {
    stack = environment::build(device(), *setup.environment);
    setup.desc.environment.stack = &*stack;
  }
  frame::Renderer renderer(device(), scene, setup.desc);
  renderer.draw();
  image::Image picture = renderer.read();
  EXPECT_TRUE(is_finite(picture));
  return picture;
}

environment::Map environment_of(int width, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
  environment::Map map = environment::constant(glm::vec3(0.0f));
  map.width = width;
  map.height = width / 2;
  map.rgb.clear();
  for (int y = 0; y < width / 2; ++y)
    for (int x = 0; x < width; ++x) {
      // DESIGN: u = atan2(z, x) / 2 pi + 1 / 2, v = acos(y) / pi.
      const double phi = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
      const double theta = (y + 0.5) / (width / 2) * std::numbers::pi;
      const glm::dvec3 value = radiance(
          {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
      for (int c = 0; c < 3; ++c)
        map.rgb.push_back(static_cast<float>(value[c]));
    }
  return map;
}

glm::dvec3 view_direction(const scene::Camera& camera, int width, int height, double x, double y) {
  const double tan_half = std::tan(0.5 * static_cast<double>(camera.fovy));
  const glm::dvec3 in_view(tan_half * width / height * (2.0 * (x + 0.5) / width - 1.0),
                           tan_half * (1.0 - 2.0 * (y + 0.5) / height), -1.0);
  return glm::normalize(glm::dmat3(camera.world) * in_view);
}

std::optional<glm::dvec3> hit_ball(glm::dvec3 from, glm::dvec3 direction) {
  const double b = glm::dot(from, direction), c = glm::dot(from, from) - 1.0;
  const double inside = b * b - c;
  if (inside <= 0.0) return std::nullopt;
  return from + (-b - std::sqrt(inside)) * direction;
}

glm::dvec3 rgb(const image::Image& picture, int x, int y) {
  return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

} // namespace gg::test
