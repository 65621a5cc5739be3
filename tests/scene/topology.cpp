// Triangles come out as the specification orders them.
#include "scene/gltf/topology.h"

#include "scene/gltf_file.h"
#include "scene/load.h"

#include <gtest/gtest.h>

using namespace gg;
using namespace gg::test;
using scene::gltf::Mode;
using scene::gltf::triangle_list;

namespace {

using Corners = std::vector<std::uint32_t>;

TEST(topology, lists_are_kept) {
  EXPECT_EQ(triangle_list({0, 1, 2, 2, 1, 3}, Mode::triangles), (Corners{0, 1, 2, 2, 1, 3}));
}

TEST(topology, strips_alternate_their_winding) {
  EXPECT_EQ(triangle_list({0, 1, 2, 3, 4}, Mode::strip), (Corners{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(topology, stitches_of_a_strip_vanish_and_keep_its_rhythm) {
  EXPECT_EQ(triangle_list({0, 1, 2, 2, 3, 3, 4, 5}, Mode::strip), (Corners{0, 1, 2, 3, 5, 4}));
}

TEST(topology, fans_turn_about_their_first_corner) {
  EXPECT_EQ(triangle_list({0, 1, 2, 3}, Mode::fan), (Corners{1, 2, 0, 2, 3, 0}));
}

TEST(topology, incomplete_triangles_are_dropped) {
  EXPECT_EQ(triangle_list({0, 1, 2, 3}, Mode::triangles), (Corners{0, 1, 2}));
  EXPECT_TRUE(triangle_list({0, 1}, Mode::strip).empty());
}

TEST(topology, strips_fans_and_lists_of_a_square_cover_it_from_the_same_side) {
  for (const int mode : {4, 5, 6}) {
    GltfFile file;
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    const Corners order = mode == 4   ? Corners{0, 1, 2, 0, 2, 3}
                          : mode == 5 ? Corners{0, 1, 3, 2}
                                      : Corners{0, 1, 2, 3};
    const int indices = file.accessor(order, "SCALAR");
    file.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}, {"mode", mode}});
    const auto scene = scene::load(file.save());
    const auto c = corners(scene, first(scene));
    ASSERT_EQ(c.size(), 6u);
    float area = 0.0f;
    for (std::size_t i = 0; i < 6; i += 3)
      area += 0.5f * glm::cross(c[i + 1] - c[i], c[i + 2] - c[i]).z;
    EXPECT_EQ(area, 1.0f) << "mode " << mode;
  }
}

TEST(topology, points_and_lines_are_left_out) {
  for (const int mode : {0, 1, 2, 3}) {
    GltfFile file;
    file.triangle();
    file.primitive()["mode"] = mode;
    const auto scene = scene::load(file.save());
    EXPECT_EQ(scene.triangle_count(), 0u);
    EXPECT_TRUE(scene.instances.empty());
  }
}

TEST(topology, missing_indices_count_up) {
  GltfFile file;
  file.triangle();
  const auto scene = scene::load(file.save());
  EXPECT_EQ(scene.indices.at(0), (Corners{0, 1, 2}));
}

} // namespace
