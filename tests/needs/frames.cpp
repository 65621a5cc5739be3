// The frame does what the needs say, and nothing more.
#include "environment/stack.h"
#include "frame/renderer.h"
#include "render/shapes.h"
#include "support/devices.h"
#include "support/pictures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gg::test {
namespace {

constexpr int size = 48;

struct Drawn {
  image::Image picture;
  std::vector<std::string> passes, listed;
  std::size_t bytes = 0, expected = 0; // on the device, for this frame
  std::uint64_t draws = 0;
};

gpu::Device& device() {
  return shared_device(gpu::Backend::opengl, gpu::Surface::egl);
}

// Under a sky that is brighter above.
Drawn draw(const scene::Scene& scene) {
  environment::Map map = environment::constant(glm::vec3(0.5f));
  map.width = 4;
  map.height = 2;
  map.rgb.assign(24, 0.25f);
  std::fill_n(map.rgb.begin(), 12, 1.0f);
  const environment::Stack stack = environment::build(device(), map);
  device().finish();
  Drawn drawn;
  const std::size_t before = device().memory_bytes();
  frame::Renderer renderer(device(), scene,
                           {.width = size,
                            .height = size,
                            .samples = 2,
                            .camera = camera_at({0, 0, 6}),
                            .environment = {.stack = &stack},
                            .method = frame::Method::lobes2});
  drawn.bytes = device().memory_bytes() - before + environment::bytes_of(map);
  drawn.expected = renderer.needs().bytes();
  const std::uint64_t draws = device().counters().draws;
  renderer.draw();
  drawn.draws = device().counters().draws - draws;
  drawn.picture = renderer.read();
  drawn.passes = renderer.pass_labels();
  for (const needs::Pass& pass : renderer.needs().passes)
    drawn.listed.push_back(pass.label);
  EXPECT_TRUE(is_finite(drawn.picture));
  return drawn;
}

void expect_same(const Drawn& a, const Drawn& b) {
  EXPECT_EQ(a.passes, b.passes);
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_EQ(a.draws, b.draws);
  EXPECT_TRUE(a.picture.values == b.picture.values) << "not the same pixels";
}

glm::mat4 at(const glm::vec3& place) {
  return glm::translate(glm::mat4(1.0f), place);
}

// Something of everything: a metal that has company, glass behind glass, and a wall before them.
scene::Scene company() {
  scene::Scene scene = ball(glass(0.2f));
  add(scene, ball(metal(0.2f)), at({-1.2f, 0.8f, -2}));
  add(scene, box(glass(0.1f)), at({1.4f, 0, -2.5f}));
  add(scene, square(unlit(glm::vec3(0.8f, 0.2f, 0.2f))), at({0.9f, -1.2f, 2}));
  return scene;
}

} // namespace

TEST(needs, the_frame_runs_exactly_the_passes_that_are_listed) {
  for (const scene::Scene& scene : {ball(dielectric(0.5f)), company()}) {
    const Drawn drawn = draw(scene);
    EXPECT_EQ(drawn.passes, drawn.listed);
    EXPECT_EQ(drawn.bytes, drawn.expected);
  }
}

TEST(needs, an_unused_feature_changes_neither_passes_nor_pixels_nor_cost) {
  const scene::Scene plain = company();
  scene::Scene laden = plain;
  laden.images.push_back(std::make_shared<image::Image8>(
      image::Image8{.width = 2, .height = 1, .rgba = {1, 2, 3, 4, 5, 6, 7, 8}}));
  laden.textures.push_back({.image = static_cast<scene::Index>(laden.images.size()) - 1});
  scene::Material unused = glass(0.3f);
  unused.base_color_map.texture = static_cast<scene::Index>(laden.textures.size()) - 1;
  unused.distribution = scene::Distribution::beckmann;
  unused.dispersion = 1.0f;
  unused.alpha_mode = scene::AlphaMode::blend;
  // A mesh that no instance shows, of a material that nothing else has.
  scene::Scene other = box(unused);
  add(laden, other, at({0, 0, 0}));
  laden.instances.pop_back();
  laden.bounds = plain.bounds;
  expect_same(draw(plain), draw(laden));
}

TEST(needs, what_is_not_in_the_view_changes_no_pixel) {
  const scene::Scene plain = company();
  scene::Scene laden = plain;
  add(laden, ball(metal(0.1f)), at({40, 0, 0}));
  add(laden, ball(glass(0.4f)), at({0, 0, 12}));
  add(laden, box(dielectric(0.4f)), at({0, -30, -4}));
  laden.bounds.include({41, -31, -5});
  expect_same(draw(plain), draw(laden));
}

TEST(needs, glass_that_cannot_be_seen_is_not_drawn) {
  const scene::Scene plain = company();
  scene::Scene laden = plain;
  add(laden, ball(glass(0.7f, 1.0f)), at({0, 0.3f, 1}));
  laden.bounds = plain.bounds;
  expect_same(draw(plain), draw(laden));
}

} // namespace gg::test
