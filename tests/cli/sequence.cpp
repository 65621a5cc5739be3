// groundglass capture --frames-out as a user meets it.
#include "image/image.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

// A white triangle that crosses the picture in half a second.
std::string moving() {
  const float numbers[] = {0,  0,    0, 1, 0, 0, 0, 1, 0, // positions
                           0,  0.5f,                      // times
                           -2, 0,    0, 2, 0, 0};         // places
  const fs::path file = scratch_directory() / "input.gltf";
  std::ofstream(scratch_directory() / "input.bin", std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers), sizeof numbers);
  std::ofstream(file) << R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "extensionsUsed": ["KHR_materials_unlit"],
    "materials": [{"extensions": {"KHR_materials_unlit": {}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "animations": [{"name": "across",
                    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                    "samplers": [{"input": 1, "output": 2}]}],
    "buffers": [{"uri": "input.bin", "byteLength": 68}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                    {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR"},
                  {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}]})";
  return file;
}

// The mean column of what is drawn.
double middle(const fs::path& path) {
  const image::Image picture = image::read(path);
  double sum = 0.0, weight = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double v = picture.at(x, y);
      sum += v * (x + 0.5), weight += v;
    }
  return sum / weight;
}

std::vector<std::string> call(const std::string& scene, const fs::path& out,
                              const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"capture",   scene,      "--frames-out", out,       "--fps",
                                 "4",         "--env",    "none",         "--size",  "48x24",
                                 "--samples", "1",        "--eye",        "0,0.5,5", "--target",
                                 "0,0.5,0",   "--format", "exr"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

} // namespace

TEST(sequence, is_the_animation_at_even_times_and_each_frame_what_time_draws) {
  const fs::path out = scratch_directory() / "frames";
  const std::string scene = moving();
  const Finished f = run_program(call(scene, out));
  ASSERT_EQ(f.code, 0) << f.err;
  EXPECT_NE(f.out.find("3 frames"), std::string::npos) << f.out; // 0, .25 and .5 s
  const double left = middle(out / "frame-000000.exr"), half = middle(out / "frame-000001.exr"),
               right = middle(out / "frame-000002.exr");
  EXPECT_LT(left + 5.0, half);
  EXPECT_LT(half + 5.0, right);
  EXPECT_FALSE(fs::exists(out / "frame-000003.exr"));
  const fs::path one = scratch_directory() / "one.exr";
  const Finished single = run_program({"capture", scene, "-o", one, "--time", "0.25", "--animation",
                                       "across", "--env", "none", "--size", "48x24", "--samples",
                                       "1", "--eye", "0,0.5,5", "--target", "0,0.5,0"});
  ASSERT_EQ(single.code, 0) << single.err;
  EXPECT_EQ(image::read(one).values, image::read(out / "frame-000001.exr").values);
}

TEST(sequence, goes_on_where_it_was_broken_off_and_keeps_what_is_there) {
  const fs::path out = scratch_directory() / "frames";
  const std::string scene = moving();
  ASSERT_EQ(run_program(call(scene, out)).code, 0);
  fs::remove(out / "frame-000001.exr");
  const fs::file_time_type before = fs::last_write_time(out / "frame-000000.exr");
  const Finished f = run_program(call(scene, out));
  ASSERT_EQ(f.code, 0) << f.err;
  EXPECT_NE(f.out.find("2 were there already"), std::string::npos) << f.out;
  EXPECT_TRUE(fs::exists(out / "frame-000001.exr"));
  EXPECT_EQ(fs::last_write_time(out / "frame-000000.exr"), before);
}

TEST(sequence, of_other_options_is_not_mixed_in) {
  const fs::path out = scratch_directory() / "frames";
  const std::string scene = moving();
  ASSERT_EQ(run_program(call(scene, out)).code, 0);
  const Finished f = run_program(call(scene, out, {"--method", "lobes1"}));
  EXPECT_EQ(f.code, 2);
  EXPECT_NE(f.err.find("frames of another sequence"), std::string::npos) << f.err;
}

TEST(sequence, that_cannot_be_is_refused_in_words) {
  const fs::path out = scratch_directory() / "frames";
  const std::string scene = moving();
  const auto refused = [&](const std::vector<std::string>& more, const std::string& naming) {
    const Finished f = run_program(call(scene, out, more));
    EXPECT_EQ(f.code, 2) << f.err;
    EXPECT_NE(f.err.find(naming), std::string::npos) << f.err;
    EXPECT_FALSE(fs::exists(out));
  };
  refused({"--animation", "back"}, "0 (across)");
  refused({"--from", "2", "--to", "1"}, "--to");
  refused({"--to", "1e9"}, "4000000001 frames");
  refused({"--time", "1"}, "--time");
  refused({"-o", "x.png"}, "-o");
  const Finished still =
      run_program({"capture", asset("scenes/Suzanne/Suzanne.gltf").string(), "--frames-out", out});
  EXPECT_EQ(still.code, 2);
  EXPECT_NE(still.err.find("has no animations"), std::string::npos) << still.err;
}

} // namespace gg::test
