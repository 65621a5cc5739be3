// From GLSL to SPIR-V, and what the SPIR-V says about itself.
#include "core/error.h"
#include "core/files.h"
#include "gpu/fixture.h"
#include "gpu/shaders/compile.h"

#include <filesystem>
#include <thread>

namespace gg::gpu::shaders {
namespace {

class Shaders : public testing::TestWithParam<Backend> {
protected:
  Reflection reflected(const std::string& file, const std::vector<Constant>& constants = {}) {
    return reflect(specialize(*compile(stage(file), GetParam()), constants, GetParam()));
  }
  std::string message(const std::function<void()>& action) {
    try {
      action();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::internal) << error.what();
      return error.what();
    }
    return "";
  }
};

using Names = std::vector<std::string>;

Names names(const std::vector<Binding>& bindings) {
  Names result;
  for (const Binding& binding : bindings)
    result.push_back(binding.name);
  return result;
}

TEST_P(Shaders, blocks_are_reflected_by_their_block_names) {
  const Reflection r = reflected("square.comp");
  EXPECT_EQ(names(r.bindings), (Names{"Settings", "Input", "Output"}));
  EXPECT_EQ(r.bindings[0].kind, Kind::uniform_block);
  EXPECT_EQ(r.bindings[0].binding, 0u);
  EXPECT_EQ(r.bindings[0].bytes, 16u + 3 * 16 + 4); // up to its last member
  EXPECT_EQ(r.bindings[1].kind, Kind::storage_block);
  EXPECT_EQ(r.bindings[1].binding, 7u);
  EXPECT_TRUE(r.bindings[1].reads);
  EXPECT_FALSE(r.bindings[1].writes);
  EXPECT_FALSE(r.bindings[2].reads);
  EXPECT_TRUE(r.bindings[2].writes);
  for (const Binding& binding : r.bindings) {
    EXPECT_EQ(binding.set, 0u);
    EXPECT_EQ(binding.count, 1u);
  }
  EXPECT_EQ(r.local_size, (std::array<std::uint32_t, 3>{64, 1, 1}));
  const Module module = specialize(*compile(stage("square.comp"), GetParam()), {}, GetParam());
  EXPECT_EQ(module.words[r.bindings[1].binding_word], 7u);
}

TEST_P(Shaders, images_and_samplers_are_reflected_with_shape_and_format) {
  const Reflection cube = reflected("sample_cube.comp");
  EXPECT_EQ(cube.bindings[0].kind, Kind::sampled);
  EXPECT_EQ(cube.bindings[0].shape, Shape::cube);
  EXPECT_EQ(reflected("sample_cubes.comp").bindings[0].shape, Shape::cube_array);
  EXPECT_EQ(reflected("sample_volume.frag").bindings[0].shape, Shape::d3);
  EXPECT_TRUE(reflected("sample_integers.frag").bindings[0].integer);
  const Reflection image = reflected("double_rgba16f.comp");
  EXPECT_EQ(names(image.bindings), (Names{"from", "to"}));
  EXPECT_EQ(image.bindings[0].kind, Kind::image);
  EXPECT_EQ(image.bindings[0].format, Format::rgba16f);
  EXPECT_FALSE(image.bindings[0].writes);
  EXPECT_FALSE(image.bindings[1].reads);
  const Reflection both = reflected("add_to_image.comp");
  EXPECT_TRUE(both.bindings[1].reads && both.bindings[1].writes);
}

TEST_P(Shaders, inputs_and_outputs_are_reflected) {
  const Reflection r = reflected("flat.vert");
  ASSERT_EQ(r.inputs.size(), 2u);
  EXPECT_EQ(r.inputs[0].name, "inPosition");
  EXPECT_EQ(r.inputs[0].components, 3u);
  EXPECT_TRUE(r.inputs[0].floats);
  EXPECT_EQ(r.inputs[1].location, 1u);
  ASSERT_EQ(r.outputs.size(), 1u);
  EXPECT_EQ(r.outputs[0].name, "outColor");
}

TEST_P(Shaders, constants_are_reflected_and_fixed) {
  const std::vector<ConstantInfo> all =
      reflect(*compile(stage("constants.frag"), GetParam())).constants;
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0].name, "useMap");
  EXPECT_EQ(all[1].bits, 1u);
  EXPECT_EQ(all[2].bits, 7u);
  EXPECT_EQ(all[3].bits, 0x3f000000u); // 0.5
  EXPECT_EQ(all[4].id, 5u);
  EXPECT_TRUE(reflected("constants.frag").constants.empty());
}

TEST_P(Shaders, what_a_disabled_feature_binds_is_gone) {
  EXPECT_TRUE(names(reflected("constants.frag").bindings).empty());
  EXPECT_EQ(names(reflected("constants.frag", {constant(0, true)}).bindings), (Names{"map"}));
  EXPECT_EQ(names(reflected("constants.frag", {constant(0, true), constant(5, true)}).bindings),
            (Names{"map", "Table"}));
  EXPECT_TRUE(names(reflected("constants.frag", {constant(5, true)}).bindings).empty());
}

TEST_P(Shaders, each_file_is_included_once) {
  const Reflection r = reflected("once.comp");
  EXPECT_EQ(names(r.bindings), (Names{"Numbers"}));
  EXPECT_EQ(r.local_size, (std::array<std::uint32_t, 3>{8, 4, 2}));
}

TEST_P(Shaders, faults_name_file_and_line) {
  EXPECT_TRUE(says(message([&] { compile(stage("bad.frag"), GetParam()); }),
                   {"wrong.glsl:3: ", "undeclared"}));
  const auto text = [&](const std::string& body) {
    return message([&] { compile_text("stages/x.frag", Stage::fragment, body, GetParam()); });
  };
  EXPECT_TRUE(says(text("#version 450\n#include \"not/there.glsl\"\nvoid main() {}\n"),
                   {"stages/x.frag:2", "not/there.glsl"}));
  EXPECT_TRUE(says(text("#version 450\nvoid main() {\n"), {"stages/x.frag:"}));
  EXPECT_TRUE(says(text("#version 450\nvoid other() {}\n"), {"stages/x.frag"}));
  EXPECT_TRUE(says(text(""), {"stages/x.frag"}));
}

TEST_P(Shaders, resources_need_numbers_of_their_own) {
  // OpenGL's rules give both of them number 0, Vulkan's give them none.
  const std::vector<std::string> unbound = {stage("unbound.comp")};
  EXPECT_TRUE(says(message([&] { link("unbound", unbound, {}, GetParam()); }),
                   {"unbound.comp", "binding"}));
  // Both have a binding 3: one a block, the other a sampler.
  const std::vector<std::string> stages = {stage("clash.vert"), stage("constants.frag")};
  EXPECT_TRUE(
      says(message([&] { link("clash", stages, std::vector{constant(0, true)}, GetParam()); }),
           {"clash", "Table", "3"}));
}

TEST_P(Shaders, linked_ahead_fail_only_when_they_are_needed) {
  const std::vector<std::string> good = {stage("square.comp")}, bad = {stage("bad.frag")};
  link_ahead("good", good, {}, GetParam());
  link_ahead("bad", bad, {}, GetParam());
  EXPECT_EQ(link("good", good, {}, GetParam()).modules.front().words,
            link("another", good, {}, GetParam()).modules.front().words);
  for (int twice = 0; twice < 2; ++twice)
    EXPECT_TRUE(says(message([&] { link("bad", bad, {}, GetParam()); }), {"wrong.glsl:3: "}));
}

TEST_P(Shaders, compile_in_several_threads_and_are_remembered) {
  const std::vector<std::string> files = {"flat.vert", "square.comp", "shaded.frag", "sample.frag"};
  std::vector<std::shared_ptr<const Module>> modules(16);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < modules.size(); ++i)
      threads.emplace_back(
          [&, i] { modules[i] = compile(stage(files[i % files.size()]), GetParam()); });
  }
  for (std::size_t i = 0; i < modules.size(); ++i)
    EXPECT_EQ(modules[i], compile(stage(files[i % files.size()]), GetParam()));
}

TEST_P(Shaders, every_stage_of_the_program_compiles) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(home_directory() / "shaders" / "stages")) {
    const std::string extension = entry.path().extension();
    if (extension != ".vert" && extension != ".frag" && extension != ".comp") continue;
    EXPECT_EQ(message([&] { compile(entry.path().string(), GetParam()); }), "");
    ++count;
  }
  EXPECT_GT(count, 0);
}

} // namespace

INSTANTIATE_TEST_SUITE_P(clients, Shaders, testing::Values(Backend::opengl, Backend::vulkan),
                         [](const auto& of) {
                           return of.param == Backend::opengl ? "opengl" : "vulkan";
                         });

} // namespace gg::gpu::shaders
