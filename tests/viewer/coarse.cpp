// Pictures in motion: fewer triangles, and nobody sees it.
#include "scene/coarse.h"

#include "environment/stack.h"
#include "frame/renderer.h"
#include "scene/framing.h"
#include "scene/load.h"
#include "support/devices.h"
#include "support/pictures.h"

#include <gtest/gtest.h>

#include <map>

namespace gg::viewer {
namespace {

const std::string ball_grid = GROUNDGLASS_SOURCE_DIR "/assets/scenes/ball-grid.glb";

// Edges of triangles that have no neighbour beyond; vertices at one place count as one.
std::size_t open_edges(const scene::Indices& indices, const scene::Stream& positions) {
  std::map<std::array<float, 6>, int> edges;
  const auto place = [&](std::uint32_t i) { return &positions.values[3 * i]; };
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const float* a = place(indices[i]);
    const float* b = place(indices[i % 3 == 2 ? i - 2 : i + 1]);
    if (std::ranges::equal(std::span(a, 3), std::span(b, 3)))
      continue; // of a triangle without area
    ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
    --edges[{b[0], b[1], b[2], a[0], a[1], a[2]}];
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(edges, [](const auto& edge) { return edge.second > 0; }));
}

TEST(coarse, meshes_stay_closed_and_within_their_error) {
  const scene::Scene scene = scene::load(ball_grid);
  const scene::CoarseLists lists = scene::coarse_lists(scene);
  ASSERT_FALSE(lists.empty());
  for (const scene::Mesh& mesh : scene.meshes)
    for (const scene::Primitive& primitive : mesh.primitives) {
      const auto found = lists.find(primitive.indices);
      if (found == lists.end()) continue;
      const auto& whole = scene.indices[static_cast<std::size_t>(primitive.indices)];
      const auto& positions = scene.streams[static_cast<std::size_t>(primitive.positions)];
      const float size = 2.0f * primitive.bounds.radius();
      std::size_t finer = whole.size();
      EXPECT_LE(found->second.front().error, 0.003f * size);
      for (const scene::CoarseList& list : found->second) {
        EXPECT_LE(2 * list.indices.size(), finer);
        EXPECT_LE(open_edges(list.indices, positions), open_edges(whole, positions));
        EXPECT_LE(list.error,
                  (0.003f + 0.01f + 0.03f) * size); // errors of lists made one of another add
        finer = list.indices.size();
      }
    }
}

TEST(coarse, a_small_picture_is_as_with_all_triangles_and_a_near_one_has_all) {
  const scene::Scene scene = scene::load(ball_grid);
  const scene::CoarseLists lists = scene::coarse_lists(scene);
  gpu::Device& device = test::shared_device(gpu::Backend::opengl, gpu::Surface::egl);
  environment::Map sky{.name = "sky", .width = 16, .height = 8};
  for (int i = 0; i < 16 * 8; ++i)
    for (const float c : {0.4f, 0.5f, 0.6f})
      sky.rgb.push_back(c + 0.02f * static_cast<float>(i % 16));
  const environment::Stack stack = environment::build(device, sky);
  frame::FrameDesc desc{
      .width = 120, .height = 90, .samples = 4, .method = frame::Method::standard};
  desc.environment.stack = &stack;
  desc.camera = scene::default_camera(scene, 4.0f / 3.0f);
  frame::Renderer renderer(device, scene, desc);
  const auto drawn = [&](const scene::CoarseLists* used) {
    renderer.use_coarse(used);
    renderer.set(desc);
    renderer.draw();
    return renderer.read();
  };
  const image::Image whole = drawn(nullptr), coarse = drawn(&lists);
  EXPECT_NE(coarse.values, whole.values);
  // A ball's outline moves by a tenth of a pixel.
  EXPECT_TRUE(test::pictures_agree(coarse, whole, {.difference = 0.05, .fraction_over = 0.02}));
  desc.camera.fovy *= 0.02f; // as near as that
  EXPECT_EQ(drawn(&lists).values, drawn(nullptr).values);
}

} // namespace
} // namespace gg::viewer
