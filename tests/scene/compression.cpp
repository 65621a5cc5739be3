// Compressed geometry comes out as it went in.
#include "core/error.h"
#include "scene/grid.h"
#include "scene/load.h"
#include "support/errors.h"

#include <gtest/gtest.h>

using namespace gg;
using namespace gg::test;

namespace {

template <class Make>
scene::Scene loaded(Make&& make) {
  GltfFile file;
  file.mesh(make(file, Grid(12)));
  return scene::load(file.save());
}

TEST(draco, gives_back_the_mesh) {
  const auto scene = loaded(with_draco), original = loaded(plain);
  EXPECT_EQ(corners(scene, first(scene)), corners(original, first(original)));
}

TEST(draco, edgebreaker_gives_back_the_corners_in_an_order_of_its_own) {
  const auto sorted = [](const scene::Scene& scene) {
    auto all = corners(scene, first(scene));
    std::ranges::sort(all, [](const auto& a, const auto& b) {
      return std::lexicographical_compare(&a[0], &a[0] + a.length(), &b[0], &b[0] + b.length());
    });
    return all;
  };
  EXPECT_EQ(sorted(loaded(with_edgebreaker)), sorted(loaded(plain)));
}

TEST(draco, is_decoded_once_for_primitives_that_share_it) {
  GltfFile file;
  const auto primitive = with_draco(file, Grid(12));
  file.mesh(primitive);
  file.json["materials"].push_back({{"name", "other"}});
  auto other = primitive;
  other["material"] = 0;
  file.mesh(other);
  const auto scene = scene::load(file.save());
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.streams.size(), 2u);
  EXPECT_EQ(scene.indices.size(), 1u);
}

TEST(draco, a_method_that_does_not_exist_is_refused) {
  GltfFile file;
  file.mesh(with_draco(file, Grid(3)));
  const std::string_view all(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  constexpr std::size_t method_at = 8; // after the name, two bytes of version and the kind
  file.bytes.at(all.find("DRACO") + method_at) = std::byte{7};
  EXPECT_TRUE(fails_with(ExitCode::input, {"KHR_draco_mesh_compression", "method 7"},
                         [&] { scene::load(file.save()); }));
}

TEST(meshopt, gives_back_the_mesh) {
  const auto scene = loaded(with_meshopt), original = loaded(plain);
  const auto &p = first(scene), &o = first(original);
  EXPECT_EQ(values(scene, p.positions), values(original, o.positions));
  // The index codec may turn a triangle's corners, not its winding.
  const auto a = corners(scene, p), b = corners(original, o);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); i += 3)
    EXPECT_TRUE((a[i] == b[i] && a[i + 1] == b[i + 1]) || (a[i] == b[i + 1] && a[i + 1] == b[i + 2])
                || (a[i] == b[i + 2] && a[i + 1] == b[i]));
  constexpr float quantisation = 0.02f; // two steps of 1/127 in the octahedron's plane
  for (std::size_t i = 0; i < values(scene, p.normals).size() / 3; ++i)
    EXPECT_LT(glm::length(vec3_at(scene, p.normals, i) - vec3_at(original, o.normals, i)),
              quantisation);
}

} // namespace
