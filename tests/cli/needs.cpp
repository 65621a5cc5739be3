// groundglass needs as a user meets it.
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace gg::test {
namespace {

nlohmann::json json_in(const std::string& path) {
  std::ifstream in(path);
  return nlohmann::json::parse(in);
}

} // namespace

// OpenGL counts what was asked for, to the byte; Vulkan what it took for it.
TEST(needs_command, tells_the_passes_and_the_bytes_that_capture_takes) {
  const std::string picture = scratch_directory() / "picture.exr",
                    told = scratch_directory() / "needs.json",
                    taken = scratch_directory() / "capture.json";
  for (const char* scene : {"scenes/Suzanne/Suzanne.gltf", "scenes/ball-grid.glb"}) {
    const std::vector<std::string> view{asset(scene), "--size",   "64x48",  "--samples",
                                        "2",          "--method", "lobes2", "--json"};
    std::vector<std::string> needs{"needs"}, capture{"capture", "-o", picture};
    needs.insert(needs.end(), view.begin(), view.end());
    capture.insert(capture.end(), view.begin(), view.end());
    needs.push_back(told);
    capture.push_back(taken);
    const Finished printed = run_program(needs);
    ASSERT_EQ(printed.code, 0) << printed.err;
    ASSERT_EQ(run_program(capture).code, 0);
    const nlohmann::json a = json_in(told), b = json_in(taken);
    EXPECT_EQ(a.at("bytes"), b.at("device_memory_bytes")) << scene;
    EXPECT_EQ(a.at("triangles"), b.at("triangles")) << scene;
    nlohmann::json labels = nlohmann::json::array();
    for (const auto& pass : a.at("passes")) {
      labels.push_back(pass.at("label"));
      EXPECT_NE(printed.out.find(pass.at("label").get<std::string>()), std::string::npos);
    }
    EXPECT_EQ(labels, b.at("passes")) << scene;
  }
}

TEST(needs_command, names_what_is_wrong_with_its_options) {
  const std::string scene = asset("scenes/Suzanne/Suzanne.gltf");
  EXPECT_EQ(run_program({"needs"}).code, 2);
  EXPECT_EQ(run_program({"needs", "/no/such/model.glb"}).code, 3);
  EXPECT_EQ(run_program({"needs", scene, "--samples", "0"}).code, 2);
  EXPECT_EQ(run_program({"needs", scene, "--smith", "john"}).code, 2);
  EXPECT_EQ(run_program({"needs", scene, "--json", "/dev/null/needs.json"}).code, 5);
}

} // namespace gg::test
