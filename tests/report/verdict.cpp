// Errors told apart by the objects' materials.
#include "report/verdict.h"

#include <gtest/gtest.h>

namespace gg::report {
namespace {

scene::Scene scene_of(const std::vector<scene::Material>& materials) {
  scene::Scene scene;
  for (const scene::Material& m : materials) {
    const auto i = static_cast<scene::Index>(scene.materials.size());
    scene.materials.push_back(m);
    scene.meshes.push_back({.name = "", .primitives = {scene::Primitive{.material = i}}});
    scene.instances.push_back({.mesh = i});
  }
  return scene;
}

scene::Material material(float metallic, float roughness, float transmission = 0.0f,
                         float thickness = 0.0f) {
  scene::Material m;
  m.metallic = metallic;
  m.roughness = roughness;
  m.transmission = transmission;
  m.thickness = thickness;
  return m;
}

} // namespace

TEST(kinds, name_material_and_band_of_alpha) {
  scene::Material unlit;
  unlit.unlit = true;
  const auto kinds = kinds_of(scene_of(
      {material(1, 0), material(0, 0.3f), material(0, 0.5f, 1, 1), material(0, 1, 1), unlit}));
  const auto is = [&](std::size_t i, const char* name, const char* band) {
    EXPECT_EQ(kinds[i].material, name);
    EXPECT_EQ(kinds[i].roughness, band);
  };
  is(0, "metal", "0");
  is(1, "dielectric", "to .1"); // alpha .09
  is(2, "glass", "to .3");
  is(3, "thin glass", "over .3");
  is(4, "unlit", "");
  EXPECT_FALSE(kinds[4].shaded);
}

TEST(kinds, of_an_object_of_several_materials_are_mixed) {
  scene::Scene scene = scene_of({material(1, 0), material(0, 1)});
  scene.meshes[0].primitives.push_back({.material = 1});
  const ObjectKind kind = kinds_of(scene).front();
  EXPECT_EQ(kind.material, "mixed");
  EXPECT_EQ(kind.roughness, "several");
}

TEST(verdict, counts_shaded_objects_alone_and_pools_them_by_kind) {
  // Three columns of objects: metal, unlit, glass; the test is wrong by .1, 9 and .2 there.
  constexpr int width = 30, height = 10;
  image::Picture truth{.name = "truth", .colour = image::Image(width, height, 3)};
  image::Picture picture{.name = "picture", .colour = image::Image(width, height, 3)};
  truth.standard_error = image::Image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      truth.id.push_back(static_cast<float>(1 + x / 10));
      truth.coverage.push_back(1.0f);
      for (int c = 0; c < 3; ++c) {
        truth.colour.at(x, y, c) = 0.3f;
        picture.colour.at(x, y, c) =
            0.3f + std::array{0.1f, 9.0f, 0.2f}[static_cast<std::size_t>(x / 10)];
      }
    }
  const std::vector<ObjectKind> kinds{
      {"metal", "0", true}, {"unlit", "", false}, {"glass", "0", true}};
  const Verdict v = judge(picture, truth, kinds).verdict;
  EXPECT_NEAR(v.objects.relmse, 0.5 * (0.01 + 0.04) / 0.1, 1e-6); // rounding of floats
  EXPECT_NEAR(v.objects.bias, 0.15, 1e-6);
  EXPECT_GT(v.frame.relmse, 100.0);
  ASSERT_EQ(v.by_class.size(), 2u);
  EXPECT_EQ(v.by_class[0].name, "glass");
  EXPECT_NEAR(v.by_class[0].relmse, 0.4, 1e-6);
  EXPECT_NEAR(v.by_class[1].relmse, 0.1, 1e-6);
  ASSERT_EQ(v.by_roughness.size(), 1u);
  EXPECT_EQ(v.by_roughness[0].pixels, 200u);
  EXPECT_NEAR(v.by_roughness[0].relmse, 0.25, 1e-6);
  EXPECT_NEAR(v.by_roughness[0].relmse_trimmed, 0.25, 1e-6);

  picture.colour.at(3, 4, 1) = 1000.0f; // one pixel of the metal's hundred
  const Verdict one = judge(picture, truth, kinds).verdict;
  EXPECT_GT(one.by_class[1].relmse, 1e4);
  EXPECT_NEAR(one.by_class[1].relmse_trimmed, 0.1, 1e-6);
}

TEST(verdict, of_a_scene_without_shaded_objects_is_the_frames) {
  image::Picture black{.name = "black", .colour = image::Image(8, 8, 3)};
  const Judged judged = judge(black, black, {});
  EXPECT_EQ(judged.verdict.objects.pixels, 64u);
  EXPECT_EQ(judged.verdict.objects.relmse, 0.0);
  EXPECT_TRUE(judged.verdict.by_class.empty());
}

} // namespace gg::report
