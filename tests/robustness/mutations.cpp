// Seeded damage to sound scenes: whatever happens to the bytes, a scene or a gg::Error that names
// the file. Nothing else may be thrown, and under the sanitizers nothing else may happen.
#include "core/error.h"
#include "core/files.h"
#include "scene/framing.h"
#include "scene/grid.h"
#include "scene/load.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace gg;
using namespace gg::test;
using nlohmann::json;

// Where the sanitizers watch, a refused allocation must look to the libraries as it does without
// them: std::bad_alloc.
extern "C" const char* __asan_default_options() {
  return "allocator_may_return_null=1:detect_leaks=1";
}

namespace {

using Bytes = std::vector<std::byte>;

// Loads the file and looks at what came out; returns whether it loaded. (Of millions of values not one expectation each: under
// the sanitizers they would take most of the time.)
bool survives(const std::filesystem::path& path) {
  try {
    const scene::Scene scene = scene::load(path);
    for (const scene::Stream& stream : scene.streams)
      EXPECT_TRUE(std::ranges::all_of(stream.values, [](float x) { return std::isfinite(x); }));
    for (const scene::Mesh& mesh : scene.meshes)
      for (const scene::Primitive& p : mesh.primitives) {
        EXPECT_GE(p.material, 0);
        EXPECT_LT(static_cast<std::size_t>(p.material), scene.materials.size());
        const auto count = scene.streams[static_cast<std::size_t>(p.positions)].count();
        EXPECT_TRUE(std::ranges::all_of(scene.indices[static_cast<std::size_t>(p.indices)],
                                        [&](std::uint32_t i) { return i < count; }));
        for (const scene::Index stream : {p.normals, p.tangents, p.colors})
          if (stream != scene::none) {
            EXPECT_EQ(scene.streams[static_cast<std::size_t>(stream)].count(), count);
          }
      }
    const scene::Camera camera = scene::default_camera(scene, 1.0f);
    EXPECT_TRUE(std::isfinite(camera.far) && camera.near > 0.0f && camera.near < camera.far);
    return true;
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == ExitCode::input || error.code() == ExitCode::unsupported);
    EXPECT_NE(std::string(error.what()).find(path.filename()), std::string::npos) << error.what();
    return false;
  }
}

// Everything that geometry can be stored as, in one file.
GltfFile rich() {
  GltfFile file;
  const Grid grid(3);
  const std::size_t vertices = grid.positions.size() / 3;
  auto& j = file.json;
  j["materials"] = {{{"normalTexture", {{"index", 0}}},
                     {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}},
                     {"extensions",
                      {{"KHR_materials_volume", {{"thicknessFactor", 1}}},
                       {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}}}}},
                     {"extras", {{"groundglass", {{"preset", "glass"}, {"color", {1, 1, 1}}}}}}}};
  j["textures"] = {{{"source", 0}, {"sampler", 0}},
                   {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
  j["samplers"] = {{{"minFilter", 9987}}};
  j["images"] = {{{"uri", "data:image/png;base64,"
                          "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4z8AAAAMBAQD3"
                          "A0FDAAAAAElFTkSuQmCC"}}};
  auto first = plain(file, grid);
  std::vector<float> uvs;
  for (std::size_t i = 0; i < vertices; ++i)
    uvs.insert(uvs.end(), {grid.positions[3 * i], grid.positions[3 * i + 1]});
  first["attributes"]["TEXCOORD_0"] = file.accessor(uvs, "VEC2");
  first["material"] = 0;
  first["targets"] = {{{"POSITION", file.accessor(grid.normals, "VEC3")}}};
  file.mesh(first);
  j["meshes"][0]["weights"] = {0.5};

  auto second = with_meshopt(file, grid);
  second["attributes"]["JOINTS_0"] =
      file.accessor(std::vector<std::uint8_t>(4 * vertices, 0), "VEC4");
  second["attributes"]["WEIGHTS_0"] =
      file.accessor(std::vector<float>(4 * vertices, 0.25f), "VEC4");
  file.mesh(second);
  file.mesh(with_draco(file, grid));

  auto strip = plain(file, grid);
  strip["mode"] = 5;
  strip["attributes"].erase("NORMAL");
  const std::uint8_t places[] = {0, 5};
  const float moved[] = {1, 2, 3, 4, 5, 6};
  j["accessors"][strip["attributes"]["POSITION"].get<int>()]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", file.view(places, 2)}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.view(moved, sizeof moved)}}}};
  file.mesh(strip);

  j["nodes"][1]["skin"] = 0;
  j["nodes"].push_back({{"camera", 0}, {"children", {5}}, {"rotation", {0, 0, 0, 1}}});
  j["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                        {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}});
  j["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
  j["skins"] = {{{"joints", {4, 5}}}};
  j["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  j["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
  return file;
}

TEST(damaged_scenes, the_undamaged_file_loads) {
  EXPECT_TRUE(survives(rich().save()));
}

// A random member of a JSON value, at any depth.
json& pick(json& value, std::mt19937& random) {
  json* at = &value;
  while (at->is_structured() && !at->empty() && (at == &value || random() % 16 != 0)) {
    auto next = at->begin();
    std::advance(next, random() % at->size());
    at = &*next;
  }
  return *at;
}

json surprise(std::mt19937& random, const json& old) {
  switch (random() % 14) {
  case 0:
    return nullptr;
  case 1:
    return -1;
  case 2:
    return 0;
  case 3:
    return 1;
  case 4:
    return 4294967296;
  case 5:
    return std::uint64_t{18446744073709551615u};
  case 6:
    return 1e38;
  case 7:
    return -0.5;
  case 8:
    return "\xC3\xA9\x01";
  case 9:
    return json::array();
  case 10:
    return json::object();
  case 11:
    return true;
  case 12:
    return static_cast<int>(random() % 8);
  default:
    return old.is_number_integer() ? json(old.get<std::int64_t>() + 1) : json::array({old, old});
  }
}

TEST(damaged_scenes, json_with_something_else_in_it) {
  std::mt19937 random(1);
  int loaded = 0;
  for (int i = 0; i < 1500; ++i) {
    GltfFile file = rich();
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      json& at = pick(file.json, random);
      at = surprise(random, at);
    }
    if (file.json.is_object()) loaded += survives(file.save());
  }
  EXPECT_GT(loaded, 20); // some changes do not matter
}

TEST(damaged_scenes, json_with_members_missing) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    GltfFile file = rich();
    json& parent = pick(file.json, random);
    if (parent.is_object() && !parent.empty()) {
      auto member = parent.begin();
      std::advance(member, random() % parent.size());
      parent.erase(member);
    }
    survives(file.save());
  }
}

Bytes bytes_of(const GltfFile& file) {
  return read_file(file.save("whole.glb"));
}

void flip(Bytes& bytes, std::size_t from, std::mt19937& random) {
  for (auto flips = 1 + random() % 8; flips > 0; --flips)
    bytes[from + random() % (bytes.size() - from)] ^= static_cast<std::byte>(1u << (random() % 8));
}

TEST(damaged_scenes, binary_with_flipped_bits) {
  std::mt19937 random(3);
  const Bytes whole = bytes_of(rich());
  std::uint32_t json_length = 0;
  std::memcpy(&json_length, whole.data() + 12, 4);
  for (int i = 0; i < 1500; ++i) {
    Bytes bytes = whole;
    flip(bytes, 20 + json_length, random);
    survives(scratch_file("flipped.glb", bytes));
  }
}

TEST(damaged_scenes, anything_with_flipped_bits) {
  std::mt19937 random(4);
  const Bytes whole = bytes_of(rich());
  for (int i = 0; i < 800; ++i) {
    Bytes bytes = whole;
    flip(bytes, 0, random);
    survives(scratch_file("flipped.glb", bytes));
  }
}

TEST(damaged_scenes, cut_short) {
  const Bytes whole = bytes_of(rich());
  for (std::size_t length = 0; length < whole.size(); length += 1 + length / 64)
    EXPECT_FALSE(survives(scratch_file("cut.glb", std::span(whole).first(length)))) << length;
}

// The models that ship with the program, cut short and with flipped bits.
TEST(damaged_scenes, shipped_models) {
  std::mt19937 random(5);
  for (const char* name :
       {"AnisotropyStrengthTest.glb", "MetalRoughSpheresNoTextures.glb", "GlassVaseFlowers.glb"}) {
    const Bytes whole = read_file(asset(std::string("scenes/") + name));
    for (int i = 1; i < 24; ++i)
      EXPECT_FALSE(
          survives(scratch_file("cut.glb", std::span(whole).first(whole.size() * i / 24))));
    for (int i = 0; i < 24; ++i) {
      Bytes bytes = whole;
      flip(bytes, 0, random);
      survives(scratch_file("flipped.glb", bytes));
    }
  }
}

} // namespace
