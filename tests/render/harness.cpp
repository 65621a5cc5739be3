#include "render/harness.h"

#include "environment/stack.h"
#include "support/devices.h"
#include "support/pictures.h"

#include <cmath>
#include <numbers>

namespace gg::test {
namespace {

// The stack of the environment that was drawn last: most tests draw several pictures under one. Forgotten after each test, as
// devices end before statics do.
class LastStack : public ::testing::EmptyTestEventListener {
public:
  const environment::Stack& of(gpu::Device& device, const environment::Map& map) {
    const bool known = stack_ && device_ == &device && map_.width == map.width
                       && map_.height == map.height && map_.rgb == map.rgb;
    if (!known) {
      stack_ = environment::build(device, map);
      map_ = map;
      device_ = &device;
    }
    return *stack_;
  }
  void OnTestEnd(const ::testing::TestInfo&) override { stack_.reset(); }

private:
  const gpu::Device* device_ = nullptr;
  environment::Map map_;
  std::optional<environment::Stack> stack_;
};

LastStack& last_stack() {
  static LastStack* const registered = [] {
    auto* made = new LastStack; // owned by gtest
    ::testing::UnitTest::GetInstance()->listeners().Append(made);
    return made;
  }();
  return *registered;
}

} // namespace

gpu::Device& Render::device() const {
  return shared_device(GetParam().backend, GetParam().surface);
}

frame::FrameDesc Render::lit(const Setup& setup) const {
  frame::FrameDesc desc = setup.desc;
  if (setup.environment) desc.environment.stack = &last_stack().of(device(), *setup.environment);
  return desc;
}

image::Image Render::draw(const scene::Scene& scene, Setup setup) const {
  frame::Renderer renderer(device(), scene, lit(setup));
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
