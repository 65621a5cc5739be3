#include "viewer/save_materials.h"

#include "scene/apply.h"
#include "scene/load.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

namespace gg::viewer {
namespace {

const std::string ball_grid = GROUNDGLASS_SOURCE_DIR "/assets/scenes/ball-grid.glb";

// The materials as the loader reads them back are those of the view.
TEST(save_materials, a_copy_is_read_back_as_it_was_edited) {
  const auto folder = test::scratch_directory();
  View view{.scene = ball_grid, .materials = {"*=,distribution=beckmann"}};
  view.edits.resize(3);
  view.edits[1] = {.preset = "gold", .settings = {{"alpha", "0.123456"}}};
  view.edits[2] = {.preset = "glass",
                   .settings = {{"attenuation_color", "0.25/0.5/0.75"}, {"ior", "1.625"}}};
  scene::Scene wanted = scene::load(ball_grid);
  for (const std::string& spec : view.all_materials())
    scene::apply_material(wanted, spec);
  const auto path = folder / "copy.glb";
  save_materials(view, scene::load(ball_grid), path.string());

  const scene::Scene copy = scene::load(path);
  ASSERT_EQ(copy.materials.size(), wanted.materials.size());
  for (std::size_t i = 0; i < copy.materials.size(); ++i) {
    const scene::Material &a = copy.materials[i], &b = wanted.materials[i];
    EXPECT_EQ(a.preset, b.preset) << i;
    EXPECT_EQ(a.distribution, b.distribution) << i;
    EXPECT_EQ(scene::microfacet_alpha(a), scene::microfacet_alpha(b)) << i;
    EXPECT_EQ(a.attenuation_color, b.attenuation_color) << i;
    EXPECT_EQ(a.ior, b.ior) << i;
  }
}

TEST(save_materials, refuses_another_kind_of_file) {
  EXPECT_TRUE(test::fails_with(ExitCode::usage, {"copy.gltf", ".glb"}, [] {
    save_materials({.scene = ball_grid}, scene::load(ball_grid), "copy.gltf");
  }));
}

} // namespace
} // namespace gg::viewer
