#include "viewer/picking.h"

#include <gtest/gtest.h>

namespace gg::viewer {
namespace {

// A triangle in the plane z, seen from +Z.
scene::Scene triangles(const std::vector<float>& depths) {
  scene::Scene scene;
  scene.materials.resize(1);
  scene.streams.push_back({3, {-1.0f, -1.0f, 0.0f, 1.0f, -1.0f, 0.0f, 0.0f, 1.0f, 0.0f}});
  scene.indices.push_back({0, 1, 2});
  scene::Primitive primitive{.positions = 0, .normals = 0, .indices = 0, .material = 0};
  primitive.bounds.include({-1.0f, -1.0f, 0.0f});
  primitive.bounds.include({1.0f, 1.0f, 0.0f});
  scene.meshes.push_back({"triangle", {primitive}});
  for (const float z : depths) {
    scene::Instance instance{.mesh = 0};
    instance.world[3].z = z;
    scene.instances.push_back(instance);
  }
  return scene;
}

constexpr Ray towards{{0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}};

TEST(pick, finds_the_nearest) {
  const auto picked = pick(triangles({-1.0f, 1.0f, 0.0f}), towards);
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->instance, 1);
  EXPECT_FLOAT_EQ(picked->distance, 4.0f);
  EXPECT_FLOAT_EQ(picked->normal.z, 1.0f);
}

TEST(pick, misses_what_is_beside_or_behind) {
  EXPECT_FALSE(pick(triangles({0.0f}), {{3.0f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}}));
  EXPECT_FALSE(pick(triangles({9.0f}), towards));
}

TEST(pick, passes_through_backs_unless_they_are_drawn) {
  scene::Scene scene = triangles({0.0f});
  const Ray from_behind{{0.0f, 0.0f, -5.0f}, {0.0f, 0.0f, 1.0f}};
  EXPECT_FALSE(pick(scene, from_behind));
  scene.materials[0].double_sided = true;
  EXPECT_TRUE(pick(scene, from_behind));
}

TEST(ray_through, passes_the_corners_of_the_picture) {
  scene::Camera camera;
  camera.fovy = 1.57079633f;
  const Ray corner = ray_through(camera, {0.0f, 0.0f}, 2.0f);
  EXPECT_NEAR(corner.direction.x / -corner.direction.z, -2.0f, 1e-5f);
  EXPECT_NEAR(corner.direction.y / -corner.direction.z, 1.0f, 1e-5f);
}

} // namespace
} // namespace gg::viewer
