// What tells a solid that is closed, convex or of flat faces.
#include "scene/solid_shape.h"

#include "interior/models.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// As most generators write it: cos and sin of whole turns, poles of as many vertices as there are columns. `radius` is by
// direction.
template <class Radius>
scene::Scene generated_ball(int columns, int rows, const Radius& radius) {
  scene::Scene s;
  scene::Stream positions{3, {}};
  scene::Indices indices;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const float theta = static_cast<float>(j) / static_cast<float>(rows) * 3.14159274f;
      const float phi = static_cast<float>(i) / static_cast<float>(columns) * 6.28318548f;
      const glm::vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                        -std::sin(theta) * std::sin(phi));
      const glm::vec3 p = radius(d) * d;
      positions.values.insert(positions.values.end(), {p.x, p.y, p.z});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      indices.insert(indices.end(), {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j),
                                     at(i + 1, j + 1), at(i + 1, j)});
  scene::Primitive p;
  p.positions = p.normals = 0;
  p.indices = p.material = 0;
  s.streams.push_back(std::move(positions));
  s.indices.push_back(std::move(indices));
  s.meshes.push_back({"ball", {p}});
  return s;
}

float round_ball(const glm::vec3&) {
  return 1.0f;
}

// A dent of a tenth of the radius, smooth and about .6 wide.
float dented(const glm::vec3& d) {
  const float away = glm::distance(d, glm::normalize(glm::vec3(1, 0.4f, 0.3f)));
  return 1.0f - 0.1f * std::exp(-20.0f * away * away);
}

// Positions as optimisers store them: whole steps of the longest side over 2^bits - 1, from the low corner.
scene::Scene quantised(scene::Scene s, int bits) {
  std::vector<float>& values = s.streams[0].values;
  scene::Bounds bounds;
  for (std::size_t i = 0; i < values.size(); i += 3)
    bounds.include({values[i], values[i + 1], values[i + 2]});
  const glm::vec3 extent = bounds.high - bounds.low;
  const float step = std::max({extent.x, extent.y, extent.z}) / static_cast<float>((1 << bits) - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float low = bounds.low[static_cast<int>(i % 3)];
    values[i] = low + step * std::round((values[i] - low) / step);
  }
  return s;
}

TEST(solid_shape, seams_that_do_not_meet_to_the_last_bit_are_closed) {
  for (const float distance : {0.0f, 30.0f}) {
    const scene::SolidShape shape =
        shape_of(moved(generated_ball(64, 32, round_ball), glm::vec3(distance), 1.0f));
    EXPECT_TRUE(shape.closed) << distance;
    EXPECT_TRUE(shape.convex) << distance;
  }
}

TEST(solid_shape, quantised_positions_neither_open_nor_dent) {
  for (const int bits : {14, 16})
    for (const int columns : {32, 200, 600}) {
      const scene::Scene ball = generated_ball(columns, columns / 2, round_ball);
      // Turned, so that no side lies along the steps.
      scene::Scene turned = ball;
      const glm::mat3 turn(glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(1, 2, 3)));
      for (std::size_t i = 0; i < turned.streams[0].values.size(); i += 3) {
        float* const v = turned.streams[0].values.data() + i;
        const glm::vec3 p = turn * glm::vec3(v[0], v[1], v[2]);
        v[0] = p.x, v[1] = p.y, v[2] = p.z;
      }
      for (const scene::Scene& one : {ball, turned}) {
        const scene::SolidShape shape = shape_of(quantised(one, bits));
        EXPECT_TRUE(shape.closed) << bits << " bits, " << columns << " columns";
        EXPECT_TRUE(shape.convex) << bits << " bits, " << columns << " columns";
      }
    }
}

TEST(solid_shape, quantised_or_not_a_smooth_dent_is_found) {
  for (const int columns : {64, 200, 600}) {
    const scene::Scene ball = generated_ball(columns, columns / 2, dented);
    for (const scene::Scene& one : {ball, quantised(ball, 14)}) {
      EXPECT_TRUE(shape_of(one).closed) << columns;
      EXPECT_FALSE(shape_of(one).convex) << columns;
    }
  }
  EXPECT_FALSE(shape_of(quantised(torus(1.5f), 14)).convex);
  EXPECT_FALSE(shape_of(quantised(wineglass(1.5f), 14)).convex);
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
