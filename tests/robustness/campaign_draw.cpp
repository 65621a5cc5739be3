#include "robustness/campaign_draw.h"

#include "environment/map.h"
#include "environment/stack.h"
#include "frame/renderer.h"
#include "image/image.h"
#include "robustness/keeping_device.h"
#include "scene/framing.h"
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "scene/origin.h"
#include "support/devices.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

namespace gg::test {
namespace {

constexpr std::pair<gpu::Backend, gpu::Surface> backends[] = {
    {gpu::Backend::opengl, gpu::Surface::egl}, {gpu::Backend::vulkan, gpu::Surface::automatic}};

// By backend, until stop_drawing().
std::map<gpu::Backend, KeepingDevice>& devices() {
  static std::map<gpu::Backend, KeepingDevice> made;
  return made;
}

gpu::Device& device_of(gpu::Backend backend, gpu::Surface surface) {
  // Mesa's software drivers compile without optimising: 24 x 24 pixels do not pay for it.
  ::setenv("GALLIVM_PERF", "nopt", 0);
  return devices().try_emplace(backend, shared_device(backend, surface)).first->second;
}

} // namespace

bool draw_small(const std::filesystem::path& file, const scene::Scene* given) {
  const environment::Map map =
      given ? environment::constant(glm::vec3(0.6f, 0.8f, 1.0f)) : environment::load(file);
  scene::Scene scene = given ? *given : scene::load(asset("scenes/slabs-0.2.glb"));
  frame::FrameDesc desc{.width = 24, .height = 24, .samples = 1};
  desc.camera = scene::default_camera(scene, 1.0f);
  for (const scene::Camera& camera : scene.cameras)
    if (camera.fault.empty()) desc.camera = camera;
  scene::move_origin_to(desc.camera, scene);
  for (const auto& [backend, surface] : backends) {
    gpu::Device& device = device_of(backend, surface);
    const environment::Stack stack = environment::build(device, map);
    desc.environment.stack = &stack;
    frame::Renderer renderer(device, scene, desc);
    renderer.draw();
    EXPECT_FALSE(image::find_non_finite(renderer.read()).has_value())
        << (backend == gpu::Backend::opengl ? "opengl" : "vulkan");
  }
  return true;
}

void stop_drawing() {
  devices().clear();
}

} // namespace gg::test
