// Where the search could go astray: what is right there, and that nothing is NaN or endless.
#include "interior/models.h"
#include "interior/score.h"
#include "support/devices.h"
#include "truth/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>

namespace gg::test {
namespace {

gpu::Device& opengl() {
  return shared_device(gpu::Backend::opengl, gpu::Surface::egl);
}

Score score_of(gpu::Device& device, const scene::Scene& scene, const ProbeDesc& desc) {
  Score score;
  const ProbeResult found = probe(device, scene, desc);
  EXPECT_TRUE(is_sound(found));
  score.add(found, walk(scene, desc.camera, desc.width, desc.height));
  return score;
}

scene::Camera orthographic(scene::Camera camera) {
  camera.orthographic = true;
  camera.magnification = glm::vec2(0.7f);
  return camera;
}

// The camera's eye put somewhere, looking the same way.
scene::Camera from(scene::Camera camera, const glm::vec3& eye) {
  camera.world[3] = glm::vec4(eye, 1.0f);
  camera.near = 0.01f;
  return camera;
}

TEST(hard_shapes, a_prism_of_60_degrees) {
  // Seen along the faces' bisectors: light leaves by sides that face the viewer.
  const Score score =
      score_of(opengl(), prism(1.5f), {.bounces = 4, .camera = camera_from({0.3f, 0.5f, 1.0f})});
  EXPECT_GE(share_within(5.0 * degree, score.errors), 92.0);
}

TEST(hard_shapes, a_hollow_box_needs_the_second_pair) {
  const scene::Scene box = hollow_box(1.5f);
  const scene::Camera camera = camera_from({0.35f, 0.25f, 1.0f});
  const Score one = score_of(opengl(), box, {.pairs = 1, .bounces = 4, .camera = camera});
  const Score two = score_of(opengl(), box, {.pairs = 2, .bounces = 4, .camera = camera});
  EXPECT_GE(share_within(0.01, two.apart), 97.0);
  EXPECT_GT(share_within(0.01, two.apart), share_within(0.01, one.apart));
}

TEST(hard_shapes, a_thin_slab_at_60_degrees) {
  const Score score = score_of(opengl(), box({1, 1, 0.04f}, 1.5f),
                               {.bounces = 4, .camera = camera_from({0.866f, 0.0f, 0.5f})});
  EXPECT_GE(share_within(5.0 * degree, score.by_reflections[0]), 99.0);
}

TEST(hard_shapes, an_orthographic_camera) {
  for (const auto& [scene, pairs] : {std::pair(sphere(1.5f), 1), std::pair(torus(1.5f), 2)}) {
    const Score score = score_of(
        opengl(), scene, {.pairs = pairs, .camera = orthographic(camera_from({0.3f, 0.8f, 1.0f}))});
    EXPECT_GE(share_within(5.0 * degree, score.by_reflections[0]), 99.0);
    EXPECT_GE(share_within(5.0 * degree, score.errors), 93.0);
  }
}

TEST(hard_shapes, a_close_up_that_fills_the_picture) {
  // What leaves outside the picture cannot be found, and says so; what leaves within is found.
  const scene::Scene ball = sphere(1.5f);
  const ProbeDesc desc{.camera = from(camera_from({0.0f, 0.0f, 1.0f}), {0.0f, 0.0f, 0.75f})};
  const ProbeResult found = probe(opengl(), ball, desc);
  EXPECT_TRUE(is_sound(found));
  const std::vector<Walk> truth = walk(ball, desc.camera, desc.width, desc.height);
  int right = 0, wrong = 0, pixels = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i].fate != Fate::leaves) continue;
    ++pixels;
    const Found& f = found.pixels[i];
    if (f.bounces < 0) continue;
    ++(angle(truth[i].direction, glm::dvec3(f.direction)) < 5.0 * degree ? right : wrong);
  }
  EXPECT_EQ(pixels, desc.width * desc.height);
  EXPECT_GE(right, pixels / 2);
  EXPECT_LE(wrong, pixels / 1000);
}

TEST(hard_shapes, a_camera_in_the_glass) {
  // From inside a ball, off its middle: every ray meets the back face that it looks at.
  const scene::Scene ball = sphere(1.5f);
  const ProbeDesc desc{.bounces = 0,
                       .camera = from(camera_from({0.2f, 0.1f, 1.0f}), {0.1f, 0.05f, 0.2f})};
  const ProbeResult found = probe(opengl(), ball, desc);
  EXPECT_TRUE(is_sound(found));
  const truth::Camera camera(desc.camera, desc.width, desc.height);
  for (int y = 0; y < desc.height; ++y)
    for (int x = 0; x < desc.width; ++x) {
      const Found& f = found.pixels[static_cast<std::size_t>(y * desc.width + x)];
      const truth::Ray ray = camera.through(x + 0.5, y + 0.5);
      const double b = glm::dot(ray.origin, ray.direction);
      const double t = -b + std::sqrt(b * b - glm::dot(ray.origin, ray.origin) + 0.25);
      // Its facets lie up to 5e-5 within the ball.
      ASSERT_LE(glm::distance(glm::dvec3(f.met), ray.origin + t * ray.direction), 2e-4)
          << x << ", " << y;
    }
}

TEST(hard_shapes, a_camera_in_the_glass_of_a_hollow_box) {
  // In the wall between the outside and the hole: F1 is the far side of the hole.
  const scene::Scene hollow = hollow_box(1.5f);
  const ProbeDesc desc{.pairs = 2,
                       .bounces = 0,
                       .camera = from(camera_from({0.1f, 0.05f, 1.0f}), {0.05f, 0.02f, 0.4f})};
  const ProbeResult found = probe(opengl(), hollow, desc);
  EXPECT_TRUE(is_sound(found));
  std::size_t at_hole = 0, at_outside = 0, unfinished = 0;
  for (const Found& f : found.pixels) {
    const glm::vec3 a = glm::abs(f.met);
    const float outmost = std::max({a.x, a.y, a.z});
    at_hole += std::abs(outmost - 0.25f) < 1e-3f;
    at_outside += std::abs(outmost - 0.5f) < 1e-3f;
    unfinished += f.bounces == Found::nothing;
  }
  // The hole's near face is .3 wide in a picture of .093 at its distance: it is all there is.
  EXPECT_EQ(at_hole + at_outside, found.pixels.size());
  EXPECT_GE(at_hole, found.pixels.size() * 9 / 10);
  EXPECT_EQ(unfinished, 0u);
}

TEST(hard_shapes, an_open_mesh_is_followed_to_an_end) {
  scene::Scene open = sphere(1.5f);
  open.indices[0].resize(open.indices[0].size() / 2); // the upper half of a shell
  for (const glm::vec3& view : {glm::vec3(0.0f, 0.3f, 1.0f), glm::vec3(0.1f, 1.0f, 0.2f)})
    for (const int pairs : {1, 2})
      EXPECT_TRUE(is_sound(
          probe(opengl(), open, {.pairs = pairs, .bounces = 8, .camera = camera_from(view)})));
}

TEST(hard_shapes, every_index_and_many_bounces_are_sound) {
  for (const float ior : {1.0f, 1.0001f, 0.7f, 4.0f})
    for (const scene::Scene& scene : {torus(ior), box({1, 1, 0.12f}, ior)})
      EXPECT_TRUE(
          is_sound(probe(opengl(), scene,
                         {.pairs = 2, .bounces = 8, .camera = camera_from({0.35f, 0.25f, 1.0f})})))
          << ior;
}

TEST(hard_shapes, an_object_of_any_size_is_followed_alike) {
  // Millimetres and kilometres: nothing in the search is a length of its own.
  const scene::Scene ring = torus(1.5f);
  const ProbeDesc desc{.pairs = 2, .camera = camera_from({0.3f, 0.8f, 1.0f})};
  const double reference = share_within(5.0 * degree, score_of(opengl(), ring, desc).errors);
  for (const float scale : {1e-3f, 1e3f}) {
    scene::Scene scaled = ring;
    for (float& v : scaled.streams[0].values)
      v *= scale;
    ProbeDesc same = desc;
    same.camera.world[3] = glm::vec4(scale * glm::vec3(desc.camera.world[3]), 1.0f);
    same.camera.near *= scale, same.camera.far *= scale;
    EXPECT_NEAR(share_within(5.0 * degree, score_of(opengl(), scaled, same).errors), reference,
                0.3);
  }
}

// Peeling: the four surfaces of a hollow box, one behind the other, at each pixel where it shows four.
TEST(hard_shapes, layers_lie_behind_each_other) {
  const ProbeResult found =
      probe(opengl(), hollow_box(1.5f), {.pairs = 2, .camera = camera_from({0.1f, 0.15f, 1.0f})});
  const auto depth = [&](std::size_t layer, std::size_t pixel) {
    float z;
    std::memcpy(&z, &found.layers[layer][4 * pixel], 4);
    return z;
  };
  std::size_t four = 0;
  for (std::size_t i = 0; i < found.pixels.size(); ++i) {
    const float f1 = depth(0, i), b1 = depth(1, i), f2 = depth(2, i), b2 = depth(3, i);
    EXPECT_EQ(f1 > 0.0f, b1 > 0.0f);
    EXPECT_EQ(f2 > 0.0f, b2 > 0.0f);
    if (!(f2 > 0.0f)) continue;
    ++four;
    EXPECT_TRUE(f1 > b1 && b1 > f2 && f2 > b2) << f1 << " " << b1 << " " << f2 << " " << b2;
  }
  EXPECT_GT(four, 5000u);
}

TEST(hard_shapes, both_backends_find_the_same) {
  gpu::Device& vulkan = shared_device(gpu::Backend::vulkan, gpu::Surface::automatic);
  for (const auto& [scene, pairs] :
       {std::pair(box({1, 1, 1}, 1.5f), 1), std::pair(torus(1.5f), 2)}) {
    const ProbeDesc desc{
        .width = 128, .height = 128, .pairs = pairs, .camera = camera_from({0.35f, 0.25f, 1.0f})};
    const ProbeResult a = probe(opengl(), scene, desc), b = probe(vulkan, scene, desc);
    EXPECT_TRUE(is_sound(b));
    std::size_t texels = 0, apart = 0;
    for (std::size_t layer = 0; layer < a.layers.size(); ++layer)
      for (std::size_t k = 0; k < a.layers[layer].size(); k += 4)
        texels += (a.layers[layer][k] != 0u) != (b.layers[layer][k] != 0u);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
      apart += a.pixels[i].bounces != b.pixels[i].bounces
               || glm::distance(a.pixels[i].direction, b.pixels[i].direction) > 0.01f;
    // Rounding decides about pixels at edges, and after reflections by curved faces.
    EXPECT_LE(texels, 10u);
    EXPECT_LE(apart, a.pixels.size() / 200);
  }
}

} // namespace
} // namespace gg::test
