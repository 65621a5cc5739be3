// What a WebGL2 engine could take over: 16 textures per fragment stage.
#include "core/files.h"
#include "gpu/shaders/compile.h"
#include "scene/load.h"
#include "support/scene_pipelines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace gg::test {
namespace {

class Samplers : public testing::TestWithParam<const char*> {};

TEST_P(Samplers, no_stage_reads_more_than_16_textures) {
  const scene::Scene scene = scene::load(home_directory() / "assets/scenes" / GetParam());
  for (const gpu::PipelineDesc& desc : pipelines_of(scene, needs::Method::lobes2)) {
    const std::array stages{desc.vertex, desc.fragment};
    const gpu::shaders::Program program =
        gpu::shaders::link(desc.label, stages, desc.constants, gpu::Backend::vulkan);
    const auto textures = std::ranges::count(program.bindings, gpu::shaders::Kind::sampled,
                                             &gpu::shaders::Binding::kind);
    EXPECT_LE(textures, 16) << desc.fragment;
  }
}

INSTANTIATE_TEST_SUITE_P(bundled, Samplers,
                         testing::Values("slabs-0.2.glb", "glass-behind-glass.glb", "wineglass.glb",
                                         "etched.glb", "GlassVaseFlowers.glb",
                                         "TransmissionTest.glb"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::ranges::replace_if(
                               name, [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

} // namespace
} // namespace gg::test
