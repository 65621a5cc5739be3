// Mesa compiles a shader for each set of values that it takes for constant, and keeps each in a file.
#include "support/cache_in.h"
#include "support/program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t files_in(const fs::path& directory) {
  return std::ranges::count_if(fs::recursive_directory_iterator(directory),
                               [](const fs::directory_entry& e) { return e.is_regular_file(); });
}

// Lavapipe takes uniforms for constant that branches test alone (shaders/stages/of_pixel.glsl): a frame of other numbers, or one
// with several draws of a pipeline, would wait for compilers, or crash in them. Balls of glass and metal, neighbours of each other.
TEST(capture, lavapipe_compiles_no_shader_again_for_other_numbers) {
  const fs::path kept = empty_directory("shader-variants");
  const auto compiled_after = [&](const std::vector<std::string>& numbers) {
    std::vector<std::string> arguments{"capture",   asset("scenes/ball-grid.glb").string(),
                                       "--backend", "vulkan",
                                       "--size",    "24x24",
                                       "--samples", "1",
                                       "-o",        (kept.parent_path() / "variants.exr").string()};
    arguments.insert(arguments.end(), numbers.begin(), numbers.end());
    const Finished done = run_program(arguments, {"MESA_SHADER_CACHE_DIR=" + kept.string()});
    EXPECT_EQ(done.code, 0) << done.err;
    return files_in(kept);
  };
  const auto once = compiled_after({});
  EXPECT_EQ(compiled_after({"--env-rotation", "40", "--env-intensity", "1.5"}), once);
}

} // namespace
} // namespace gg::test
