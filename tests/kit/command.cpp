// groundglass kit, as a user runs it. What it draws is chromium.py's.
#include "core/files.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

TEST(kit, writes_shaders_tables_and_an_example_for_three) {
  const fs::path folder = scratch_directory() / "made" / "kit";
  const Finished done = run_program({"kit", "--target", "three", "-o", folder.string()});
  ASSERT_EQ(done.code, 0) << done.err;
  for (const char* file :
       {"groundglass.js", "shaders.js", "index.html", "package.json", "README.md", "tables.json"})
    EXPECT_TRUE(fs::is_regular_file(folder / file)) << file;
  const std::string shaders = read_text(folder / "shaders.js");
  EXPECT_NE(shaders.find("vec3 gg_refractFrontBack("), std::string::npos);
  EXPECT_EQ(shaders.find("${"), std::string::npos);
}

TEST(kit, writes_whole_shaders_and_a_scene_without_three) {
  for (const std::string target : {"webgl2", "opengl", "vulkan"}) {
    const fs::path folder = scratch_directory() / target;
    const Finished done = run_program({"kit", "--target", target, "-o", folder.string()});
    ASSERT_EQ(done.code, 0) << done.err;
    for (const char* file : {"scene.glb", "environment.hdr", "tables.json",
                             target == "webgl2" ? "index.html" : "main.cpp"})
      EXPECT_TRUE(fs::is_regular_file(folder / file)) << file;
    const std::string glass = read_text(folder / "shaders/glass.frag");
    EXPECT_TRUE(glass.starts_with("#version")) << target;
    EXPECT_EQ(glass.find("#include"), std::string::npos) << target;
    EXPECT_EQ(glass.find("#snippets"), std::string::npos) << target;
    EXPECT_EQ(read_text(folder / "README.md").find('@'), std::string::npos) << target;
  }
}

TEST(kit, describes_every_table_by_its_size) {
  const fs::path folder = scratch_directory() / "tables";
  ASSERT_EQ(run_program({"kit", "--target", "three", "-o", folder.string()}).code, 0);
  const auto json = nlohmann::json::parse(read_text(folder / "tables.json"));
  ASSERT_EQ(json["textures"].size(), 6U);
  for (const auto& [name, table] : json["textures"].items()) {
    const std::uintmax_t texels = table["size"][0].get<std::uintmax_t>()
                                  * table["size"][1].get<std::uintmax_t>()
                                  * table["size"][2].get<std::uintmax_t>();
    EXPECT_EQ(fs::file_size(folder / table["file"].get<std::string>()), texels * 4 * 2) << name;
  }
}

TEST(kit, says_what_it_cannot_do) {
  const Finished misspelt =
      run_program({"kit", "--target", "webgl", "-o", (scratch_directory() / "x").string()});
  EXPECT_EQ(misspelt.code, 2);
  EXPECT_NE(misspelt.err.find("Did you mean webgl2?"), std::string::npos) << misspelt.err;
  EXPECT_EQ(run_program({"kit", "-o", "x"}).code, 2);
  const fs::path file = scratch_directory() / "file";
  std::ofstream(file) << "in the way";
  EXPECT_EQ(run_program({"kit", "--target", "three", "-o", (file / "kit").string()}).code, 5);
}

} // namespace
} // namespace gg::test
