// Which devices the tests of pictures run on, and that the other OpenGL surface draws the same.
#include "environment/stack.h"
#include "render/harness.h"
#include "render/shapes.h"
#include "scene/load.h"
#include "support/pictures.h"

namespace gg::test {
namespace {

image::Image portrait(gpu::Device& device, const scene::Scene& scene) {
  const environment::Map sky =
      environment_of(256, [](glm::dvec3 d) { return glm::dvec3(0.2) + d * d * d * d * 3.0; });
  const environment::Stack stack = environment::build(device, sky);
  frame::FrameDesc desc{
      .width = 160, .height = 120, .samples = 4, .camera = camera_at({1.5f, 1.0f, 4.0f})};
  desc.environment.stack = &stack;
  frame::Renderer renderer(device, scene, desc);
  renderer.draw();
  return renderer.read();
}

} // namespace

INSTANTIATE_TEST_SUITE_P(
    on, Render,
    ::testing::Values(Backend{"opengl", gpu::Backend::opengl, gpu::Surface::egl},
                      Backend{"vulkan", gpu::Backend::vulkan, gpu::Surface::automatic}),
    [](const ::testing::TestParamInfo<Backend>& backend) {
      return std::string(backend.param.name);
    });

TEST(surfaces, osmesa_and_egl_draw_the_same_picture_of_a_real_model) {
  const scene::Scene suzanne =
      scene::load(std::string(GROUNDGLASS_SOURCE_DIR) + "/assets/scenes/Suzanne/Suzanne.gltf");
  const auto on = [&](gpu::Surface surface) {
    const auto device = gpu::create_device({.surface = surface, .debug = true});
    return portrait(*device, suzanne);
  };
  const image::Image egl = on(gpu::Surface::egl), osmesa = on(gpu::Surface::osmesa);
  EXPECT_TRUE(is_finite(egl));
  // The same rasterizer behind both: bit for bit.
  EXPECT_TRUE(pictures_agree(osmesa, egl, {.difference = 0.0, .fraction_over = 0.0}, "osmesa"));
}

} // namespace gg::test
