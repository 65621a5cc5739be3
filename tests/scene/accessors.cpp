// Every way to store numbers gives the same numbers.
#include "core/error.h"
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace gg;
using namespace gg::test;

namespace {

using Floats = std::vector<float>;
const Floats square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

// A mesh that reads positions from `positions` and (so that values stay as they are) flat normals
// are not needed.
scene::Scene load_positions(GltfFile& file, int positions) {
  const int normals = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int indices = file.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  file.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}});
  return scene::load(file.save());
}

template <class T>
Floats read_as(const std::vector<T>& stored, bool normalised) {
  GltfFile file;
  const auto scene = load_positions(file, file.accessor(stored, "VEC3", normalised));
  return values(scene, first(scene).positions);
}

template <class T>
std::vector<T> as(const Floats& from, float scale) {
  std::vector<T> to;
  for (const float x : from)
    to.push_back(static_cast<T>(x * scale));
  return to;
}

TEST(accessors, every_component_type_gives_the_same_positions) {
  EXPECT_EQ(read_as<float>(square, false), square);
  EXPECT_EQ(read_as(as<std::int8_t>(square, 1), false), square);
  EXPECT_EQ(read_as(as<std::uint8_t>(square, 1), false), square);
  EXPECT_EQ(read_as(as<std::int16_t>(square, 1), false), square);
  EXPECT_EQ(read_as(as<std::uint16_t>(square, 1), false), square);
  EXPECT_EQ(read_as(as<std::uint32_t>(square, 1), false), square);
}

TEST(accessors, normalised_integers_span_zero_to_one) {
  EXPECT_EQ(read_as(as<std::int8_t>(square, 127), true), square);
  EXPECT_EQ(read_as(as<std::uint8_t>(square, 255), true), square);
  EXPECT_EQ(read_as(as<std::int16_t>(square, 32767), true), square);
  EXPECT_EQ(read_as(as<std::uint16_t>(square, 65535), true), square);
}

TEST(accessors, the_most_negative_integer_is_minus_one) {
  std::vector<std::int8_t> stored(12, 0);
  stored[0] = -128;
  stored[1] = -127;
  const Floats read = read_as(stored, true);
  EXPECT_EQ(read[0], -1.0f);
  EXPECT_EQ(read[1], -1.0f);
}

TEST(accessors, interleaved_values_are_found_by_stride_and_offset) {
  GltfFile file;
  Floats mixed; // position, then two floats of something else
  for (std::size_t i = 0; i < 4; ++i)
    mixed.insert(mixed.end(), {7, square[3 * i], square[3 * i + 1], square[3 * i + 2], 9});
  const int view = file.view(mixed.data(), mixed.size() * sizeof(float), 20);
  file.json["accessors"].push_back({{"bufferView", view},
                                    {"byteOffset", 4},
                                    {"componentType", 5126},
                                    {"count", 4},
                                    {"type", "VEC3"}});
  const auto scene = load_positions(file, 0);
  EXPECT_EQ(values(scene, first(scene).positions), square);
}

TEST(accessors, sparse_values_replace_some) {
  GltfFile file;
  const int positions = file.accessor(square, "VEC3");
  const std::uint16_t places[] = {1, 3};
  const float moved[] = {5, 6, 7, 8, 9, 10};
  file.json["accessors"][positions]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", file.view(places, sizeof places)}, {"componentType", 5123}}},
      {"values", {{"bufferView", file.view(moved, sizeof moved)}}}};
  const auto scene = load_positions(file, positions);
  EXPECT_EQ(values(scene, first(scene).positions), (Floats{0, 0, 0, 5, 6, 7, 1, 1, 0, 8, 9, 10}));
}

TEST(accessors, sparse_values_stand_alone_on_zeros) {
  GltfFile file;
  const std::uint8_t places[] = {2};
  const float value[] = {1, 2, 3};
  file.json["accessors"].push_back(
      {{"componentType", 5126},
       {"count", 4},
       {"type", "VEC3"},
       {"sparse",
        {{"count", 1},
         {"indices", {{"bufferView", file.view(places, 1)}, {"componentType", 5121}}},
         {"values", {{"bufferView", file.view(value, sizeof value)}}}}}});
  const auto scene = load_positions(file, 0);
  EXPECT_EQ(values(scene, first(scene).positions), (Floats{0, 0, 0, 0, 0, 0, 1, 2, 3, 0, 0, 0}));
}

TEST(accessors, text_and_binary_files_give_the_same_scene) {
  GltfFile file;
  file.triangle();
  const auto binary = scene::load(file.save()), text = scene::load(file.save_text());
  EXPECT_EQ(corners(binary, first(binary)), corners(text, first(text)));
}

TEST(accessors, colours_without_alpha_are_opaque) {
  GltfFile file;
  const int positions = file.accessor(square, "VEC3");
  const int colors = file.accessor(as<std::uint8_t>(square, 255), "VEC3", true);
  file.mesh({{"attributes", {{"POSITION", positions}, {"COLOR_0", colors}}}, {"mode", 5}});
  const auto scene = scene::load(file.save());
  const auto& stream = scene.streams[static_cast<std::size_t>(first(scene).colors)];
  EXPECT_EQ(stream.components, 4);
  for (std::size_t i = 3; i < stream.values.size(); i += 4)
    EXPECT_EQ(stream.values[i], 1.0f);
}

TEST(accessors, every_set_of_texture_coordinates_is_read) {
  GltfFile file;
  const int positions = file.accessor(square, "VEC3");
  const int first_set = file.accessor<float>({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2");
  const int third_set = file.accessor<float>({2, 2, 3, 2, 3, 3, 2, 3}, "VEC2");
  const int indices = file.accessor<std::uint16_t>({0, 1, 2}, "SCALAR");
  file.mesh({{"attributes",
              {{"POSITION", positions}, {"TEXCOORD_0", first_set}, {"TEXCOORD_2", third_set}}},
             {"indices", indices}});
  const auto scene = scene::load(file.save());
  ASSERT_EQ(first(scene).uvs.size(), 3u);
  EXPECT_EQ(first(scene).uvs[1], scene::none);
  EXPECT_EQ(values(scene, first(scene).uvs[2]), (Floats{2, 2, 3, 2, 3, 3}));
}

TEST(accessors, normals_come_out_as_unit_vectors) {
  GltfFile file;
  const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  // KHR_mesh_quantization: bytes, one of them unused; 90² + 90² is not 127².
  const std::int8_t stored[] = {90, 90, 0, 0, 0, 0, 127, 0, -127, 0, 0, 0};
  file.json["accessors"].push_back({{"bufferView", file.view(stored, sizeof stored, 4)},
                                    {"componentType", 5120},
                                    {"normalized", true},
                                    {"count", 3},
                                    {"type", "VEC3"}});
  file.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", 1}}}});
  const auto scene = scene::load(file.save());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(glm::length(vec3_at(scene, first(scene).normals, i)), 1.0f, 2e-7f); // 2 ulp
  EXPECT_EQ(vec3_at(scene, first(scene).normals, 1), glm::vec3(0, 0, 1));
}

} // namespace
