// The frame does what the needs say, and nothing more.
#include "environment/stack.h"
#include "frame/renderer.h"
#include "needs/left_out.h"
#include "render/shapes.h"
#include "support/devices.h"
#include "support/pictures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace gg::test {
namespace {

constexpr int size = 48;

struct Drawn {
  image::Image picture;
  std::set<std::string> passes, listed; // by what the device timed; as declared
  std::size_t bytes = 0, expected = 0;  // on the device, for this frame
  std::uint64_t draws = 0;
};

gpu::Device& device() {
  return shared_device(gpu::Backend::opengl, gpu::Surface::egl);
}

// A sky that is brighter above.
environment::Map sky() {
  environment::Map map = environment::constant(glm::vec3(0.5f));
  map.width = 4;
  map.height = 2;
  map.rgb.assign(24, 0.25f);
  std::fill_n(map.rgb.begin(), 12, 1.0f);
  return map;
}

Drawn draw(const scene::Scene& scene) {
  const environment::Map map = sky();
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
  drawn.expected = bytes_of(frame::memory_of(renderer.needs(), renderer.graph()));
  const std::uint64_t draws = device().counters().draws;
  renderer.draw();
  drawn.draws = device().counters().draws - draws;
  drawn.picture = renderer.read();
  std::map<std::string, double> times;
  renderer.draw_sample(0, &times);
  for (const auto& [label, ms] : times)
    drawn.passes.insert(label);
  for (const std::string& label : renderer.pass_labels())
    drawn.listed.insert(label);
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

// A bit of everything: a metal that has neighbours, glass behind glass, and a wall before them.
scene::Scene neighbours() {
  scene::Scene scene = ball(glass(0.2f));
  add(scene, ball(metal(0.2f)), at({-1.2f, 0.8f, -2}));
  add(scene, box(glass(0.1f)), at({1.4f, 0, -2.5f}));
  add(scene, square(unlit(glm::vec3(0.8f, 0.2f, 0.2f))), at({0.9f, -1.2f, 2}));
  return scene;
}

} // namespace

TEST(needs, the_frame_runs_exactly_the_passes_that_are_listed) {
  for (const scene::Scene& scene : {ball(dielectric(0.5f)), neighbours()}) {
    const Drawn drawn = draw(scene);
    EXPECT_EQ(drawn.passes, drawn.listed);
    EXPECT_EQ(drawn.bytes, drawn.expected);
  }
}

TEST(needs, an_unused_feature_changes_neither_passes_nor_pixels_nor_cost) {
  const scene::Scene plain = neighbours();
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

// Past what is a neighbour of something that is (needs/neighbours.h).
TEST(needs, what_is_not_in_the_view_nor_near_changes_no_pixel) {
  const scene::Scene plain = neighbours();
  scene::Scene laden = plain;
  add(laden, ball(metal(0.1f)), at({80, 0, 0}));
  add(laden, ball(glass(0.4f)), at({0, 0, 60}));
  add(laden, box(dielectric(0.4f)), at({0, -120, -4}));
  laden.bounds.include({81, -121, -5});
  expect_same(draw(plain), draw(laden));
}

TEST(needs, glass_that_cannot_be_seen_is_not_drawn) {
  const scene::Scene plain = neighbours();
  scene::Scene laden = plain;
  add(laden, ball(glass(0.7f, 1.0f)), at({0, 0.3f, 1}));
  laden.bounds = plain.bounds;
  expect_same(draw(plain), draw(laden));
}

// A renderer that is set to another frame draws it as a new one does, and creates nothing for a frame of the same kind.
TEST(needs, a_frame_that_is_set_is_the_frame_that_is_made) {
  scene::Scene scene = neighbours();
  const auto desc = [](int width, const glm::vec3& eye, frame::Method method) {
    return frame::FrameDesc{
        .width = width, .height = size, .samples = 2, .camera = camera_at(eye), .method = method};
  };
  const auto fresh = [&](const frame::FrameDesc& of) {
    frame::Renderer renderer(device(), scene, of);
    renderer.draw();
    return renderer.read();
  };
  const frame::FrameDesc first = desc(size, {0, 0, 6}, frame::Method::lobes2);
  frame::Renderer renderer(device(), scene, first);
  renderer.draw();
  for (const frame::FrameDesc& next :
       {desc(size, {0.5f, 1, 5}, frame::Method::lobes2), desc(64, {0, 0, 6}, frame::Method::lobes1),
        desc(size, {0, 0, 7}, frame::Method::standard), first}) {
    renderer.set(next);
    renderer.draw();
    EXPECT_TRUE(renderer.read().values == fresh(next).values);
  }
  scene.materials[0] = glass(0.5f, 1.3f);
  renderer.materials_changed();
  renderer.draw();
  EXPECT_TRUE(renderer.read().values == fresh(first).values);

  const gpu::DeviceCounters before = device().counters();
  renderer.set(desc(size, {0.1f, 0, 6}, frame::Method::lobes2));
  renderer.draw();
  EXPECT_EQ(device().counters().created, before.created);
  EXPECT_EQ(device().counters().compiled, before.compiled);
}

// A camera that goes round, in a picture whose size follows the time that a frame takes, and a slider of a material: what has been
// seen once makes nothing when it is seen again.
TEST(needs, the_second_turn_about_a_scene_makes_nothing) {
  for (gpu::Device* device : {&shared_device(gpu::Backend::opengl, gpu::Surface::egl),
                              &shared_device(gpu::Backend::vulkan, gpu::Surface::automatic)}) {
    scene::Scene scene = neighbours();
    const auto desc = [](int i) {
      constexpr int steps = 8, sides[] = {size, 34, 24};
      const float angle = 6.2831853f * static_cast<float>(i) / steps;
      return frame::FrameDesc{.width = sides[i % 3],
                              .height = sides[i % 3],
                              .samples = 1,
                              .camera =
                                  camera_at({6.0f * std::sin(angle), 0.0f, 6.0f * std::cos(angle)}),
                              .method = frame::Method::lobes2};
    };
    frame::Renderer renderer(*device, scene, desc(0));
    const auto turn = [&] {
      for (int i = 0; i < 24; ++i) { // every angle at every size
        renderer.set(desc(i));
        renderer.draw();
      }
      for (int i = 0; i < 5; ++i) {
        scene.materials[0] = glass(0.2f + 0.05f * static_cast<float>(i), 1.5f);
        renderer.materials_changed();
        renderer.draw();
      }
    };
    turn();
    const gpu::DeviceCounters before = device->counters();
    turn();
    EXPECT_EQ(device->counters().created, before.created);
    EXPECT_EQ(device->counters().compiled, before.compiled);
  }
}

// What a feature is worth is told by the frame without it, which is that of a material that does not have it.
TEST(needs, a_frame_without_a_feature_is_that_of_a_material_without_it) {
  const environment::Stack stack = environment::build(device(), sky());
  const auto draw = [&](const scene::Material& material, const std::string& without) {
    const scene::Scene scene = ball(material);
    frame::Renderer renderer(device(), scene,
                             {.width = 24,
                              .height = 24,
                              .samples = 1,
                              .camera = camera_at({0, 0, 4}),
                              .environment = {.stack = &stack},
                              .method = frame::Method::standard,
                              .without = needs::left_out(without)});
    renderer.draw();
    return renderer.read().values;
  };
  scene::Material absorbs = glass(0.2f), coated = metal(0.3f);
  absorbs.attenuation_color = {0.2f, 0.6f, 0.4f};
  absorbs.attenuation_distance = 0.5f;
  coated.clearcoat = 1.0f;
  coated.clearcoat_roughness = 0.2f;
  coated.iridescence = 1.0f;
  EXPECT_TRUE(draw(absorbs, "absorption") == draw(glass(0.2f), ""));
  EXPECT_FALSE(draw(absorbs, "") == draw(glass(0.2f), ""));
  EXPECT_TRUE(draw(coated, "clearcoat,iridescence") == draw(metal(0.3f), ""));
  EXPECT_FALSE(draw(coated, "clearcoat") == draw(metal(0.3f), ""));
}

} // namespace gg::test
