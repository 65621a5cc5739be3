#include "robustness/campaign_draw.h"

#include "environment/map.h"
#include "environment/stack.h"
#include "frame/renderer.h"
#include "image/image.h"
#include "scene/framing.h"
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "scene/origin.h"
#include "support/devices.h"

#include <gtest/gtest.h>

namespace gg::test {
namespace {

constexpr std::pair<gpu::Backend, gpu::Surface> backends[] = {
    {gpu::Backend::opengl, gpu::Surface::egl}, {gpu::Backend::vulkan, gpu::Surface::automatic}};

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
    gpu::Device& device = shared_device(backend, surface);
    const environment::Stack stack = environment::build(device, map);
    desc.environment.stack = &stack;
    frame::Renderer renderer(device, scene, desc);
    renderer.draw();
    EXPECT_FALSE(image::find_non_finite(renderer.read()).has_value())
        << (backend == gpu::Backend::opengl ? "opengl" : "vulkan");
  }
  return true;
}

} // namespace gg::test
