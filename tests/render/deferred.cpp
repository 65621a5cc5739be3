// Opaque surfaces are the same by their pixels and by their triangles.
#include "render/harness.h"
#include "render/shapes.h"
#include "support/pictures.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace gg::test::deferred_test {
namespace {

constexpr int size = 96;

// A step of a display's 8 bits; all that is drawn here is at most about 1.
constexpr double display_step = 1.0 / 255.0;

frame::FrameDesc from(const glm::vec3& eye) {
  return {.width = size,
          .height = size,
          .samples = 1,
          .camera = camera_at(eye),
          .method = frame::Method::lobes2};
}

glm::mat4 placed(const glm::vec3& at, const glm::vec3& scale) {
  return glm::scale(glm::translate(glm::mat4(1.0f), at), scale);
}

environment::Map sky() {
  return environment_of(64, [](glm::dvec3 d) { return 0.5 + 0.4 * d; });
}

// A mask that lets everything through is the same surface, and is drawn by its triangles.
scene::Scene by_triangle(scene::Scene scene) {
  for (scene::Material& material : scene.materials)
    if (!material.unlit && material.alpha_mode == scene::AlphaMode::opaque) {
      material.alpha_mode = scene::AlphaMode::mask;
      material.alpha_cutoff = 0.0f;
    }
  return scene;
}

scene::Material conductor() {
  scene::Material copper = metal(0.0f);
  copper.conductor = scene::Conductor{{0.2f, 0.9f, 1.1f}, {3.9f, 2.6f, 2.3f}};
  return copper;
}

// Of every kind of material, mirrored and stretched, before and behind what is drawn by triangles, and under a veil.
// Or of the two that methods differ in: each pipeline takes a second to compile.
enum class Crowd { of_all_materials, of_two };
scene::Scene crowd(Crowd who = Crowd::of_all_materials) {
  scene::Material mixed = metal(0.3f, {0.9f, 0.6f, 0.3f}), tinted = dielectric(0.2f), veil = tinted;
  mixed.metallic = 0.5f;
  mixed.emissive = {0.1f, 0.0f, 0.0f};
  tinted.specular_color = {0.5f, 0.8f, 1.0f};
  veil.alpha_mode = scene::AlphaMode::blend;
  veil.base_color.w = 0.4f;
  scene::Scene scene = ball(metal(0.2f, {0.9f, 0.8f, 0.4f}));
  if (who == Crowd::of_two) {
    add(scene, ball(dielectric(0.6f)), placed({1.2f, 0.8f, -0.5f}, {-0.5f, 0.9f, 0.7f}));
    return scene;
  }
  add(scene, ball(conductor()), placed({-1.3f, 0.9f, -1}, {-0.8f, 0.8f, 0.8f}));
  add(scene, ball(dielectric(0.6f)), placed({1.2f, 0.8f, -0.5f}, {0.5f, 0.9f, 0.7f}));
  add(scene, ball(mixed), placed({-1.1f, -0.9f, 0.6f}, glm::vec3(0.4f)));
  add(scene, ball(tinted), placed({0.9f, -0.8f, 0.5f}, glm::vec3(0.5f)));
  add(scene, square(unlit({0.2f, 0.6f, 0.9f})), placed({0.2f, 0.2f, -2}, glm::vec3(2)));
  add(scene, square(unlit({0.9f, 0.3f, 0.2f})), placed({0.4f, -0.2f, 1.2f}, glm::vec3(0.3f)));
  add(scene, square(veil), placed({-0.5f, 0.2f, 1.4f}, glm::vec3(0.6f)));
  return scene;
}

// The half of a ball that is farther from a viewer at +Z, as a bowl with two sides.
scene::Scene bowl(scene::Material material) {
  material.double_sided = true;
  scene::Scene scene = ball(material);
  const std::vector<float>& positions = scene.streams[0].values;
  scene::Indices kept;
  const scene::Indices& all = scene.indices[0];
  for (std::size_t i = 0; i + 2 < all.size(); i += 3)
    if (std::all_of(&all[i], &all[i] + 3,
                    [&](unsigned v) { return positions[3 * std::size_t{v} + 2] < 1e-6f; }))
      kept.insert(kept.end(), &all[i], &all[i] + 3);
  scene.indices[0] = kept;
  return scene;
}

} // namespace

// Depth and normals lose no more than rounding. What falls beside an edge of what is seen falls to its other side in few pixels,
// and at silhouettes the share that a neighbour takes of a lobe turns with the rounding of the normal.
TEST_P(Render, opaque_surfaces_are_the_same_by_their_pixels_and_by_their_triangles) {
  scene::Light lamp;
  lamp.intensity = glm::vec3(4.0f);
  lamp.position = {1, 2, 3};
  std::vector<frame::FrameDesc> descs(3, from({0.4f, 0.3f, 5}));
  descs[1].method = frame::Method::standard;
  descs[1].samples = 2;
  descs[1].multiple_scattering = true;
  descs[1].camera.orthographic = true;
  descs[1].camera.magnification = glm::vec2(2.0f);
  descs[2].method = needs::fis(4);
  for (const frame::FrameDesc& desc : descs) {
    scene::Scene scene =
        crowd(desc.method == frame::Method::lobes2 ? Crowd::of_all_materials : Crowd::of_two);
    scene.lights = {lamp};
    EXPECT_TRUE(pictures_agree(draw(scene, {sky(), desc}), draw(by_triangle(scene), {sky(), desc}),
                               {.difference = display_step, .fraction_over = 0.01}))
        << static_cast<int>(desc.method);
  }
}

// A floor and a rough and a nearly smooth ball in contact with it. Interpolated values are within a hundredth of what they stand
// for (MOST_BEND of shaders/stages/neighbour_cells.frag, over eight); at edges and contacts they do not stand in.
TEST_P(Render, what_neighbours_add_is_the_same_in_cells_and_at_every_pixel) {
  scene::Scene scene = ball(metal(0.4f, {0.9f, 0.6f, 0.3f}));
  add(scene, ball(metal(0.05f)), placed({2.1f, 0, 0}, glm::vec3(1)));
  add(scene, box(dielectric(0.5f)), placed({0, -1.2f, 0}, {6, 0.2f, 6}));
  frame::FrameDesc each = from({0.4f, 1.5f, 6});
  each.without.set(static_cast<std::size_t>(needs::Feature::interpolated_neighbours));
  EXPECT_TRUE(pictures_agree(draw(scene, {sky(), from({0.4f, 1.5f, 6})}),
                             draw(scene, {sky(), each}),
                             {.difference = 2.0 * display_step, .fraction_over = 0.002}));
}

TEST_P(Render, a_fine_mesh_keeps_every_pixel_of_its_outline) {
  const scene::Scene scene = crowd();
  const frame::FrameDesc desc = from({0.4f, 0.3f, 5});
  scene::Scene alone = ball(dielectric(0.5f));
  for (const scene::Scene& shown : {scene, alone, bowl(metal(0.3f))}) {
    const image::Image a = draw(shown, {std::nullopt, desc}),
                       b = draw(by_triangle(shown), {std::nullopt, desc});
    int covered = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        EXPECT_EQ(a.at(x, y, 3), b.at(x, y, 3)) << x << ", " << y;
        covered += a.at(x, y, 3) > 0.0f;
      }
    EXPECT_GT(covered, size * size / 20);
  }
}

// The inner side of a bowl, brushed aslant, and what the near plane cuts open.
TEST_P(Render, both_sides_of_a_fine_mesh_are_the_same_by_pixels) {
  for (const float distance : {4.0f, 0.9f}) {
    frame::FrameDesc desc = from({0.2f, 0.1f, distance});
    desc.camera.near = 0.5f;
    scene::Material brushed = metal(0.2f);
    brushed.anisotropy_strength = 0.7f;
    brushed.anisotropy_rotation = 0.5f;
    const scene::Scene scene = bowl(brushed);
    EXPECT_TRUE(pictures_agree(draw(scene, {sky(), desc}), draw(by_triangle(scene), {sky(), desc}),
                               {.difference = display_step, .fraction_over = 0.0}))
        << distance;
  }
}

} // namespace gg::test::deferred_test
