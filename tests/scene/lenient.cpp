// Files that are not quite glTF and that every viewer draws: drawn, with a note that says what was taken for what.
#include "core/error.h"
#include "core/files.h"
#include "scene/framing.h"
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace gg;
using namespace gg::test;
using nlohmann::json;

namespace {

struct Loaded {
  scene::Scene scene;
  std::string said;
};

Loaded load(const std::filesystem::path& path) {
  testing::internal::CaptureStderr();
  Loaded loaded;
  try {
    loaded.scene = scene::load(path);
  } catch (...) {
    testing::internal::GetCapturedStderr();
    throw;
  }
  loaded.said = testing::internal::GetCapturedStderr();
  return loaded;
}

// Names differ by test, so that each says its note in one process.
Loaded load(const GltfFile& file) {
  return load(file.save(std::string(testing::UnitTest::GetInstance()->current_test_info()->name())
                        + ".glb"));
}

::testing::AssertionResult says(const Loaded& loaded, const std::string& part) {
  if (loaded.said.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << part << "' is not in: " << loaded.said;
}

GltfFile glass() {
  GltfFile file;
  file.triangle();
  file.primitive()["material"] = 0;
  file.json["materials"] = {
      {{"extensions",
        {{"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationColor", {1, 0.5, 0}}}}}}}};
  return file;
}

TEST(lenient, no_attenuation_is_written_as_zero_or_null) {
  for (const json& distance : {json(0), json(nullptr), json(0.0)}) {
    GltfFile file = glass();
    file.json["materials"][0]["extensions"]["KHR_materials_volume"]["attenuationDistance"] =
        distance;
    EXPECT_EQ(scene::load(file.save()).materials[0].attenuation_distance, INFINITY);
  }
  GltfFile file = glass();
  file.json["materials"][0]["extensions"]["KHR_materials_volume"]["attenuationDistance"] = 0;
  EXPECT_TRUE(says(load(file), "attenuationDistance is 0"));
}

TEST(lenient, null_is_nothing) {
  GltfFile file = glass();
  file.json["materials"][0]["name"] = nullptr;
  file.json["nodes"][0]["extensions"] = nullptr;
  file.json["meshes"][0]["weights"] = nullptr;
  EXPECT_TRUE(says(load(file), "materials[0].name is null"));
  file.primitive()["attributes"] = nullptr; // needed
  EXPECT_TRUE(fails_with(ExitCode::input, {"meshes[0].primitives[0].attributes", "missing"},
                         [&] { scene::load(file.save()); }));
}

TEST(lenient, matrices_end_in_rounding) {
  GltfFile file;
  file.triangle();
  json matrix = {1, 0, 0, 1e-8, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 0.9999999};
  file.json["nodes"][0]["matrix"] = matrix;
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "nodes[0].matrix"));
  EXPECT_EQ(loaded.scene.instances[0].world * glm::vec4(1, 0, 0, 1), glm::vec4(6, 6, 7, 1));
  matrix[15] = 0.999;
  file.json["nodes"][0]["matrix"] = matrix;
  EXPECT_TRUE(fails_with(ExitCode::input, {"nodes[0].matrix"}, [&] { scene::load(file.save()); }));
}

TEST(lenient, quaternions_and_factors_end_in_rounding) {
  GltfFile file = glass();
  file.json["nodes"][0]["rotation"] = {0, 0, 0, 1.0000021};
  file.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 1.0000021;
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "nodes[0].rotation[3] is 1.0000021; taken as 1"));
  EXPECT_EQ(loaded.scene.instances[0].world, glm::mat4(1.0f));
  EXPECT_EQ(loaded.scene.materials[0].roughness, 1.0f);
}

TEST(lenient, emission_above_one_is_drawn_as_it_says) {
  GltfFile file = glass();
  file.json["materials"][0]["emissiveFactor"] = {2, 0, 0.5};
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "emissiveFactor"));
  EXPECT_EQ(loaded.scene.materials[0].emissive, glm::vec3(2, 0, 0.5));
}

TEST(lenient, equal_cones_make_a_sharp_spot) {
  GltfFile file;
  file.triangle();
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}}}}};
  file.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  file.json["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(scene::load(file.save()).lights.at(0).inner_cone, 0.5f);
}

TEST(lenient, a_stride_of_zero_is_packed) {
  GltfFile file;
  file.triangle();
  const std::vector<glm::vec3> wanted = [&] {
    const scene::Scene plain = scene::load(file.save());
    return corners(plain, first(plain));
  }();
  for (json& view : file.json["bufferViews"])
    view["byteStride"] = 0;
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "byteStride is 0"));
  EXPECT_EQ(corners(loaded.scene, first(loaded.scene)), wanted);
}

TEST(lenient, many_entries_of_one_kind_take_one_note) {
  GltfFile file = glass();
  file.triangle();
  for (json& view : file.json["bufferViews"])
    view["byteStride"] = 0;
  const std::size_t views = file.json["bufferViews"].size();
  ASSERT_GT(views, 1u);
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "bufferViews[0].byteStride is 0; taken as packed (and "
                               + std::to_string(views - 1) + " more like it)"));
  EXPECT_EQ(std::ranges::count(loaded.said, '\n'), 1) << loaded.said;
}

TEST(lenient, notes_of_what_nests_deep_are_as_few_as_they_are_short) {
  GltfFile file = glass();
  json nested = json::object();
  for (int depth = 0; depth < 50; ++depth)
    nested = {{"within", nested}, {"none", nullptr}};
  file.json["extensions"]["EXT_nested"] = nested;
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "more like it"));
  constexpr std::ptrdiff_t levels_of_a_note = 200 / 7; // "within." is 7 of the 200 letters
  EXPECT_LE(std::ranges::count(loaded.said, '\n'), levels_of_a_note + 3) << loaded.said;
}

TEST(lenient, a_near_plane_at_zero_is_set_by_what_is_seen) {
  GltfFile file;
  file.triangle();
  file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0}}}}};
  file.json["nodes"].push_back({{"camera", 0}, {"translation", {0.2, 0.2, 3}}});
  file.json["scenes"][0]["nodes"] = {0, 1};
  const Loaded loaded = load(file);
  EXPECT_TRUE(says(loaded, "znear is 0"));
  const scene::Camera& camera = scene::find_camera(loaded.scene, "0");
  EXPECT_GT(camera.near, 0.0f);
  EXPECT_LT(camera.near, 3.0f);
  EXPECT_EQ(camera.far, 0.0f); // the file does not end the view
}

TEST(lenient, what_is_wrong_with_unused_materials_harms_nothing) {
  GltfFile file = glass();
  file.json["materials"].push_back({{"emissiveFactor", {-2, 0, 0}}});
  file.json["materials"].push_back({{"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}});
  file.json["materials"].push_back({{"extras", {{"groundglass", {{"preset", "unobtainium"}}}}}});
  const Loaded loaded = load(file);
  EXPECT_EQ(loaded.scene.materials.size(), 4u);
  EXPECT_TRUE(says(loaded, "materials[1].emissiveFactor[0]"));
  EXPECT_TRUE(says(loaded, "materials[2].extensions.KHR_materials_ior.ior"));
  file.primitive()["material"] = 1;
  EXPECT_TRUE(fails_with(ExitCode::input, {"materials[1].emissiveFactor"},
                         [&] { scene::load(file.save()); }));
}

TEST(lenient, version_two_is_two_point_nought) {
  for (const json& version : {json("2"), json(2), json(2.0)}) {
    GltfFile file;
    file.triangle();
    file.json["asset"]["version"] = version;
    EXPECT_NO_THROW(scene::load(file.save()));
  }
  GltfFile file;
  file.triangle();
  file.json["asset"]["version"] = "2";
  EXPECT_TRUE(says(load(file), "asset.version is \"2\""));
}

TEST(lenient, data_uris_have_capitals_line_breaks_and_escapes) {
  GltfFile file;
  file.triangle();
  const std::string text = base64(file.bytes.data(), file.bytes.size());
  std::string broken, escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    broken += text[i];
    if (i % 16 == 15) broken += "\r\n";
    escaped += text[i] == '+'   ? "%2B"
               : text[i] == '/' ? "%2F"
               : text[i] == '=' ? "%3D"
                                : std::string(1, text[i]);
  }
  for (const std::string& uri : {"DATA:Application/Octet-Stream;BASE64," + text,
                                 "data:application/octet-stream;base64," + broken,
                                 "data:application/octet-stream;base64," + escaped}) {
    json text_file = json::parse(read_text(file.save_text()));
    text_file["buffers"][0]["uri"] = uri;
    EXPECT_NO_THROW(scene::load(scratch_file("uri.gltf", text_file.dump()))) << uri;
  }
}

// scene/a.gltf reads textures/a.bin.
TEST(lenient, uris_may_climb_as_far_as_folders_were_named) {
  GltfFile file;
  file.triangle();
  json text_file = json::parse(read_text(file.save_text()));
  text_file["buffers"][0]["uri"] = "../data/a.bin";
  const std::filesystem::path here = scratch_directory() / "model";
  std::filesystem::create_directories(here / "scene");
  std::filesystem::create_directories(here / "data");
  std::filesystem::rename(scratch_file("a.bin", std::span<const std::byte>(file.bytes)),
                          here / "data/a.bin");
  std::filesystem::rename(scratch_file("a.gltf", text_file.dump()), here / "scene/a.gltf");
  const auto before = std::filesystem::current_path();
  const auto from = [&](const std::filesystem::path& directory, const char* path) {
    std::filesystem::current_path(directory);
    try {
      scene::load(path);
    } catch (...) {
      std::filesystem::current_path(before);
      throw;
    }
    std::filesystem::current_path(before);
  };
  EXPECT_NO_THROW(scene::load(here / "scene/a.gltf")); // from the root: the folder around
  EXPECT_NO_THROW(from(here.parent_path(), "model/scene/a.gltf"));
  EXPECT_NO_THROW(from(here / "data", "../scene/../../model/scene/a.gltf"));
  for (const auto& [directory, path] :
       {std::pair(here, "scene/a.gltf"), std::pair(here / "scene", "a.gltf")})
    EXPECT_TRUE(fails_with(ExitCode::input, {"buffers[0].uri", "../data/a.bin", "named"},
                           [&] { from(directory, path); }));
  text_file["buffers"][0]["uri"] = "../../secret.bin";
  std::filesystem::rename(scratch_file("b.gltf", text_file.dump()), here / "scene/b.gltf");
  EXPECT_TRUE(fails_with(ExitCode::input, {"buffers[0].uri", "outside"},
                         [&] { scene::load(here / "scene/b.gltf"); }));
}

} // namespace
