// The shared models, drawn by the whole frame on both backends: the same pixels.
#include "environment/map.h"
#include "environment/stack.h"
#include "frame/renderer.h"
#include "scene/framing.h"
#include "scene/load.h"
#include "support/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

namespace gg {
namespace {

// Mesa's two drivers, and any two of other makers, may add the terms of dot() and mix() in another
// order; and where that rounds a texel of the environment's half floats the other way, a texel
// changes by 2^-11 of its value. Highlights are read from the brightest texels. Rounding, therefore:
// relative to the value, and absolute below a tenth of white.
constexpr double relative = 1e-3, dark = 0.1;
// A reflection next to a silhouette may fall on the other side, and so may a ray through glass that
// is followed from texel to texel: three pixels in a thousand (measured: 1.3).
constexpr double fraction_over = 3e-3;

constexpr int width = 160, height = 120;

class Side {
public:
  explicit Side(gpu::Backend backend)
      : device_(gpu::create_device({.backend = backend, .debug = true})),
        stack_(environment::build(*device_,
                                  environment::load(file("environments/studio_small_03_1k.hdr")))) {
  }

  static std::filesystem::path file(const std::string& name) {
    return std::filesystem::path(GROUNDGLASS_SOURCE_DIR) / "assets" / name;
  }
  image::Image draw(const scene::Scene& scene) const {
    frame::FrameDesc desc{.width = width, .height = height, .samples = 2};
    desc.camera = scene.cameras.empty()
                      ? scene::default_camera(scene, static_cast<float>(width) / height)
                      : scene.cameras.front();
    desc.environment.stack = &stack_;
    frame::Renderer renderer(*device_, scene, desc);
    renderer.draw();
    return renderer.read();
  }

private:
  std::unique_ptr<gpu::Device> device_;
  environment::Stack stack_;
};

// A pipeline takes seconds to compile on both: of models that repeat themselves every so many of their things are drawn.
struct Model {
  const char* name;
  std::size_t every = 1;
};
constexpr Model models[] = {{"Suzanne/Suzanne.gltf"},
                            {"shaderball.glb"},
                            {"TransmissionTest.glb", 5},
                            {"MetalRoughSpheresNoTextures.glb", 9},
                            {"AnisotropyStrengthTest.glb", 8}};

scene::Scene thinned(const Model& model) {
  scene::Scene scene = scene::load(Side::file(std::string("scenes/") + model.name));
  std::size_t i = 0;
  std::erase_if(scene.instances, [&](const scene::Instance&) { return i++ % model.every != 0; });
  return scene;
}

TEST(vulkan_agreement, shared_models_are_drawn_as_opengl_draws_them) {
  const Side opengl(gpu::Backend::opengl), vulkan(gpu::Backend::vulkan);
  for (const Model& model : models) {
    const scene::Scene scene = thinned(model);
    image::Image expected = opengl.draw(scene), found = vulkan.draw(scene);
    ASSERT_EQ(found.values.size(), expected.values.size());
    // Scaled so that one unit is what may differ there.
    for (std::size_t i = 0; i < expected.values.size(); ++i) {
      const float scale = static_cast<float>(
          1.0 / std::max(dark, std::abs(static_cast<double>(expected.values[i]))));
      expected.values[i] *= scale;
      found.values[i] *= scale;
    }
    EXPECT_TRUE(test::pictures_agree(found, expected, {relative, fraction_over}, "vulkan"))
        << model.name;
  }
}

} // namespace
} // namespace gg
