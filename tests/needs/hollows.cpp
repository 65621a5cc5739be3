// How much of what a surface sees is its own body.
#include "needs/hollows.h"

#include "core/files.h"
#include "needs/kept_hollows.h"
#include "needs/needs.h"
#include "render/shapes.h"
#include "support/cache_in.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace gg::test {
namespace {

needs::Hollows hollows(const scene::Scene& scene) {
  return needs::hollows_of(scene, needs::proxies_of(scene));
}

// The square of shapes.h and one as large above it, which face each other, as one mesh.
scene::Scene facing_squares(float apart) {
  scene::Scene scene = square(dielectric(0.5f));
  scene::Primitive& primitive = scene.meshes[0].primitives[0];
  auto& points = scene.streams[static_cast<std::size_t>(primitive.positions)].values;
  auto& normals = scene.streams[static_cast<std::size_t>(primitive.normals)].values;
  scene::Indices& indices = scene.indices[static_cast<std::size_t>(primitive.indices)];
  const std::size_t corners = points.size() / 3, triangles = indices.size() / 3;
  for (std::size_t i = 0; i < corners; ++i) {
    points.insert(points.end(), {points[3 * i], points[3 * i + 1], apart});
    normals.insert(normals.end(), {0.0f, 0.0f, -1.0f});
  }
  const auto above = static_cast<std::uint32_t>(corners);
  for (std::size_t t = 0; t < triangles; ++t)
    indices.insert(indices.end(), {above + indices[3 * t], above + indices[3 * t + 2],
                                   above + indices[3 * t + 1]});
  primitive.bounds.include(glm::vec3(1.0f, 1.0f, apart));
  return scene;
}

// A wall of 20 x 1 metres, of which vertices 0 and 1 are the lower edge and 2 and 3 the upper, and a floor in front of it: turned, so
// that coordinates are rounded.
scene::Scene wall_on_floor(float depth) {
  scene::Scene scene = square(dielectric(0.5f));
  scene::Primitive& primitive = scene.meshes[0].primitives[0];
  scene.streams[static_cast<std::size_t>(primitive.positions)].values = {
      -10, 0, 0, 10, 0, 0, -10, 1, 0, 10, 1, 0, -10, 0, 0, 10, 0, 0, -10, 0, depth, 10, 0, depth};
  scene.streams[static_cast<std::size_t>(primitive.normals)].values = {
      0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0};
  scene.indices[static_cast<std::size_t>(primitive.indices)] = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5};
  primitive.bounds = {{-10, 0, 0}, {10, 1, depth}};
  scene.instances[0].world = glm::rotate(glm::mat4(1.0f), 1.1f, glm::vec3(0.36f, 0.48f, 0.8f));
  return scene;
}

} // namespace

TEST(hollows, what_is_convex_has_none) {
  EXPECT_TRUE(hollows(ball(metal(0.3f))).of.empty());
  EXPECT_TRUE(hollows(box(metal(0.3f))).of.empty());
  EXPECT_TRUE(hollows(square(metal(0.3f))).of.empty());
}

// Of two parallel squares [Howell, C-11], side over distance x: what all of one sees of the other.
TEST(hollows, of_a_square_below_another_are_its_form_factor) {
  const needs::Hollows found = hollows(facing_squares(1.5f));
  ASSERT_EQ(found.streams.size(), 1u);
  const double x = 2.0 / 1.5, root = std::sqrt(1.0 + x * x);
  const double factor = 2.0 / (std::numbers::pi * x * x)
                        * (0.5 * std::log(root * root * root * root / (1.0 + 2.0 * x * x))
                           + 2.0 * x * root * std::atan(x / root) - 2.0 * x * std::atan(x));
  const scene::Scene scene = facing_squares(1.5f);
  const scene::Indices& corners = scene.indices[0];
  double mean = 0.0;
  for (const std::uint32_t i : corners)
    mean += static_cast<double>(found.streams[0].values[i]) / static_cast<double>(corners.size());
  EXPECT_NEAR(mean, factor, 1.0 / needs::hollow_rays) << "rays' steps";
}

// A wall of two triangles that stands on a floor: their common edge, where rounding lets rays meet either side, is no measure of the
// wall. What it sees of a floor that is much wider [Howell, C-3], between the bottom and the top.
TEST(hollows, of_a_wall_on_a_floor_are_those_of_its_middle) {
  for (const float depth : {0.3f, 0.8f, 2.0f}) {
    const scene::Scene scene = wall_on_floor(depth);
    const needs::Hollows found = hollows(scene);
    ASSERT_EQ(found.streams.size(), 1u);
    const std::vector<float>& at = found.streams[0].values;
    for (const double h : {0.15, 0.5, 0.85}) {
      const double shown = std::lerp(static_cast<double>(at[0] + at[1]) / 2.0,
                                     static_cast<double>(at[2] + at[3]) / 2.0, h);
      const double seen = 0.5 * (1.0 - h / std::hypot(h, static_cast<double>(depth)));
      EXPECT_NEAR(shown, seen, 0.1) << depth << " deep, " << h << " high: a straight line";
    }
  }
}

TEST(hollows, are_the_same_again) {
  const scene::Scene scene = facing_squares(0.7f);
  EXPECT_EQ(hollows(scene).streams.at(0).values, hollows(scene).streams.at(0).values);
}

TEST(hollows, are_kept_and_read_back_and_made_again_where_the_file_is_damaged) {
  const std::filesystem::path directory = empty_directory("kept-hollows");
  const CacheIn moved(directory);
  scene::Scene scene = facing_squares(0.7f);
  const auto kept = [&] { return needs::hollows_kept_or_of(scene, needs::proxies_of(scene)); };
  const needs::Hollows made = kept();
  const auto files = [&] { return kept_files(directory, "hollows"); };
  ASSERT_EQ(files().size(), 1u);
  const auto sound = read_file(files()[0]);
  for (const std::uintmax_t size : {sound.size(), sound.size() / 2, std::size_t{0}}) {
    std::filesystem::resize_file(files()[0], size);
    const needs::Hollows again = kept();
    EXPECT_EQ(again.of, made.of);
    EXPECT_EQ(again.streams.at(0).values, made.streams.at(0).values);
    EXPECT_TRUE(read_file(files()[0]) == sound) << size;
  }
  scene.instances[0].world[3].y += 0.1f;
  kept();
  EXPECT_EQ(files().size(), 2u);
}

TEST(hollows, are_not_asked_for_by_the_standard_method_nor_without_an_environment) {
  const scene::Scene scene = facing_squares(0.7f);
  const auto has = [&](needs::Method method, std::optional<std::size_t> environment) {
    const needs::Needs needs = needs::needs_of(scene, {.camera = camera_at({0, 0, 6}),
                                                       .width = 64,
                                                       .height = 64,
                                                       .method = method,
                                                       .environment = environment});
    return value_of(needs.draws.all.at(0).key, needs::Feature::hollows) != 0;
  };
  EXPECT_TRUE(has(needs::Method::lobes2, 0));
  EXPECT_FALSE(has(needs::Method::standard, 0));
  EXPECT_FALSE(has(needs::Method::lobes2, std::nullopt));
}

} // namespace gg::test
