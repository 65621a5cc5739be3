// Seeded damage to sound scenes: whatever happens to the bytes, a scene or a gg::Error that names
// the file. Nothing else may be thrown, and under the sanitizers nothing else may happen.
#include "core/error.h"
#include "core/files.h"
#include "robustness/damage.h"
#include "robustness/samples.h"
#include "scene/framing.h"
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

TEST(damaged_scenes, the_undamaged_file_loads) {
  EXPECT_TRUE(survives(rich().save()));
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
