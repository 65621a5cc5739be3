// What tells a solid that is closed, convex or of flat faces.
#include "scene/solid_shape.h"

#include "interior/models.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gg::test {
namespace {

scene::SolidShape shape_of(const scene::Scene& scene) {
  std::vector<const scene::Primitive*> parts;
  for (const scene::Mesh& mesh : scene.meshes)
    for (const scene::Primitive& p : mesh.primitives)
      parts.push_back(&p);
  return scene::solid_shape(scene, parts);
}

scene::Scene moved(scene::Scene s, const glm::vec3& by, float scale) {
  std::vector<float>& values = s.streams[0].values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = scale * values[i] + by[static_cast<int>(i % 3)];
  return s;
}

TEST(solid_shape, balls_and_boxes_are_convex) {
  EXPECT_TRUE(shape_of(sphere(1.5f)).convex);
  EXPECT_TRUE(shape_of(box({1, 1, 0.12f}, 1.5f)).convex);
  EXPECT_TRUE(shape_of(prism(1.5f)).convex);
  EXPECT_TRUE(shape_of(sphere(1.5f)).closed);
}

TEST(solid_shape, rounding_of_coordinates_does_not_dent) {
  // A tenth of a millimetre large and ten metres away, coordinates keep about a hundredth of the
  // ball's size.
  for (const float distance : {1.0f, 30.0f, 1000.0f})
    EXPECT_TRUE(
        shape_of(moved(box({1, 1, 1}, 1.5f), glm::vec3(distance, 0.3f, -distance), 0.1f)).convex)
        << distance;
}

TEST(solid_shape, rings_vessels_and_holes_are_closed_but_not_convex) {
  for (const scene::Scene& scene : {torus(1.5f), wineglass(1.5f), hollow_box(1.5f)}) {
    const scene::SolidShape shape = shape_of(scene);
    EXPECT_TRUE(shape.closed);
    EXPECT_FALSE(shape.convex);
  }
}

TEST(solid_shape, two_convex_bodies_are_not_one) {
  scene::Scene two = box({1, 1, 1}, 1.5f);
  add(two, moved(box({1, 1, 1}, 1.5f), {3, 0, 0}, 1.0f), glm::mat4(1.0f));
  const scene::SolidShape shape = shape_of(two);
  EXPECT_TRUE(shape.closed);
  EXPECT_FALSE(shape.convex);
}

TEST(solid_shape, a_missing_triangle_opens_it) {
  scene::Scene open = sphere(1.5f);
  open.indices[0].resize(open.indices[0].size() - 3);
  EXPECT_FALSE(shape_of(open).closed);
  EXPECT_FALSE(shape_of(open).convex);
}

TEST(solid_shape, a_triangle_that_is_turned_over_opens_it) {
  scene::Scene turned = box({1, 1, 1}, 1.5f);
  std::swap(turned.indices[0][0], turned.indices[0][1]);
  EXPECT_FALSE(shape_of(turned).closed);
}

TEST(solid_shape, an_inverted_body_is_not_convex) {
  scene::Scene inverted = sphere(1.5f);
  for (std::size_t i = 0; i < inverted.indices[0].size(); i += 3)
    std::swap(inverted.indices[0][i], inverted.indices[0][i + 1]);
  EXPECT_TRUE(shape_of(inverted).closed);
  EXPECT_FALSE(shape_of(inverted).convex);
}

TEST(solid_shape, triangles_without_area_do_not_count) {
  scene::Scene with = box({1, 1, 1}, 1.5f);
  with.indices[0].insert(with.indices[0].end(), {0, 0, 1});
  EXPECT_TRUE(shape_of(with).convex);
}

TEST(solid_shape, nothing_is_nothing) {
  scene::Scene none = sphere(1.5f);
  none.indices[0].clear();
  const scene::SolidShape shape = shape_of(none);
  EXPECT_FALSE(shape.closed || shape.convex || shape.flat);
}

TEST(solid_shape, flat_faces_are_told_from_smooth_ones) {
  EXPECT_TRUE(shape_of(box({1, 1, 1}, 1.5f)).flat);
  EXPECT_TRUE(shape_of(hollow_box(1.5f)).flat);
  EXPECT_FALSE(shape_of(sphere(1.5f)).flat);
}

TEST(solid_shape, suzanne_is_open) {
  EXPECT_FALSE(shape_of(asset("Suzanne/Suzanne.gltf", 1.5f)).closed);
}

} // namespace
} // namespace gg::test
