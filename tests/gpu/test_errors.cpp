// Faults are errors that name what is at fault, and leave the device usable.
#include "core/error.h"
#include "gpu/fixture.h"

namespace gg::gpu {
namespace {

class Errors : public OnDevice {
protected:
  // The message and the code of what `action` throws; "" if it throws nothing.
  std::string message(const std::function<void()>& action, ExitCode code = ExitCode::internal) {
    try {
      action();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      return error.what();
    }
    return "";
  }
  PipelineDesc sampling() {
    return {.label = "sampling",
            .vertex = stage("fullscreen.vert"),
            .fragment = stage("sample.frag"),
            .colors = {Format::rgba8},
            .cull = Cull::none};
  }
  // Runs a pass that draws into `color` with whatever `record` does.
  std::string drawing(const std::function<void(Encoder&)>& record, std::vector<View> reads = {}) {
    const TextureRef color = target("colour", Format::rgba8, 4, 4);
    return message([&] {
      run({.label = "tested",
           .colors = {{.view = {color}, .clear = {}}},
           .reads = std::move(reads),
           .record = record});
    });
  }
  std::string computing(const std::string& compute, const std::function<void(Encoder&)>& record,
                        Pass pass = {}) {
    const PipelineRef pipeline = device().create(ComputeDesc{compute, stage(compute), {}});
    pass.label = "tested";
    pass.record = [&](Encoder& encoder) {
      encoder.use(pipeline);
      record(encoder);
    };
    return message([&] { run(pass); });
  }
};

TEST_P(Errors, a_missing_binding_names_pipeline_and_binding) {
  const PipelineRef pipeline = device().create(sampling());
  EXPECT_TRUE(says(drawing([&](Encoder& encoder) {
                     encoder.use(pipeline);
                     encoder.draw(3);
                   }),
                   {"tested", "sampling", "map"}));
  // What was bound in the pass before is not bound any more.
  const TextureRef map = device().create(TextureDesc{.label = "map", .format = Format::r32f});
  const auto bound = [&](Encoder& encoder) {
    encoder.use(pipeline);
    encoder.texture("map", whole(map), device().create(SamplerDesc{}));
    encoder.draw(3);
  };
  EXPECT_EQ(drawing(bound), "");
  EXPECT_TRUE(says(drawing([&](Encoder& encoder) {
                     encoder.use(pipeline);
                     encoder.draw(3);
                   }),
                   {"map"}));
  EXPECT_EQ(drawing(bound), "");
}

TEST_P(Errors, a_missing_vertex_buffer_names_pipeline_and_slot) {
  const PipelineRef pipeline = device().create(flat_pipeline(Format::rgba8));
  EXPECT_TRUE(says(drawing([&](Encoder& encoder) {
                     encoder.use(pipeline);
                     encoder.draw(3);
                   }),
                   {"flat", "vertex binding 0"}));
}

TEST_P(Errors, a_missing_attribute_names_the_input) {
  PipelineDesc desc = flat_pipeline(Format::rgba8);
  desc.attributes.pop_back();
  EXPECT_TRUE(says(message([&] { device().create(desc); }), {"flat", "inColor"}));
}

TEST_P(Errors, nothing_to_draw_with) {
  EXPECT_TRUE(says(drawing([](Encoder& encoder) { encoder.draw(3); }), {"no pipeline"}));
  const PipelineRef compute = device().create(ComputeDesc{"add one", stage("add_one.comp"), {}});
  EXPECT_TRUE(says(drawing([&](Encoder& encoder) { encoder.use(compute); }), {"add one"}));
}

TEST_P(Errors, too_small_misaligned_or_foreign_blocks) {
  const BufferRef small = buffer("small", std::vector<float>(4), Use::uniforms | Use::storage);
  const BufferRef large = buffer("large", std::vector<float>(256), Use::storage);
  const auto with = [&](const BufferRef& settings, std::size_t offset) {
    return computing("square.comp",
                     [&](Encoder& encoder) {
                       encoder.buffer("Settings", settings, offset);
                       encoder.buffer("Input", large);
                       encoder.buffer("Output", large);
                       encoder.dispatch(1, 1, 1);
                     },
                     {.writes_buffers = {large}});
  };
  EXPECT_TRUE(says(with(small, 0), {"Settings", "small"}));
  EXPECT_TRUE(says(with(large, 0), {"Settings", "large"})); // no Use::uniforms
  EXPECT_TRUE(says(with(large, 16), {"Settings", "256"}));
  EXPECT_TRUE(says(with(large, 2048), {"large"}));
}

TEST_P(Errors, undeclared_writes_and_reads) {
  const BufferRef numbers = buffer("numbers", std::vector<float>(64), Use::storage);
  const auto write = [&](Encoder& encoder) {
    encoder.buffer("Numbers", numbers);
    encoder.dispatch(1, 1, 1);
  };
  EXPECT_TRUE(says(computing("add_one.comp", write), {"numbers", "writes_buffers"}));
  EXPECT_EQ(computing("add_one.comp", write, {.writes_buffers = {numbers}}), "");

  const TextureRef drawn = target("drawn", Format::rgba8, 4, 4);
  const PipelineRef pipeline = device().create(sampling());
  const auto sample = [&](Encoder& encoder) {
    encoder.use(pipeline);
    encoder.texture("map", whole(drawn), device().create(SamplerDesc{}));
    encoder.draw(3);
  };
  EXPECT_TRUE(says(drawing(sample), {"drawn", "reads"}));
  EXPECT_EQ(drawing(sample, {{drawn}}), "");
}

TEST_P(Errors, reading_what_is_drawn_into) {
  const TextureRef color = target("both", Format::rgba8, 4, 4);
  EXPECT_TRUE(says(message([&] {
                     run({.label = "loop",
                          .colors = {{.view = {color}, .clear = {}}},
                          .reads = {{color}},
                          .record = [](Encoder&) {}});
                   }),
                   {"loop", "both"}));
}

TEST_P(Errors, targets_that_do_not_fit_the_pipeline_or_each_other) {
  const PipelineRef pipeline = device().create(flat_pipeline(Format::rgba16f));
  EXPECT_TRUE(says(drawing([&](Encoder& encoder) { encoder.use(pipeline); }), {"flat"}));
  const TextureRef a = target("a", Format::rgba8, 4, 4), b = target("b", Format::rgba8, 4, 5);
  EXPECT_TRUE(says(message([&] {
                     run({.label = "sizes",
                          .colors = {{.view = {a}, .clear = {}}, {.view = {b}, .clear = {}}},
                          .record = [](Encoder&) {}});
                   }),
                   {"sizes"}));
}

TEST_P(Errors, views_and_ranges_that_do_not_exist) {
  const TextureRef map = device().create(
      TextureDesc{.label = "map", .format = Format::r32f, .width = 4, .height = 4, .levels = 2});
  const std::vector<float> texels(16);
  EXPECT_TRUE(says(message([&] { device().upload(map, 2, 0, bytes_of(texels)); }), {"map"}));
  EXPECT_TRUE(says(message([&] { device().upload(map, 1, 0, bytes_of(texels)); }), {"16 bytes"}));
  EXPECT_TRUE(says(message([&] { device().read(map, 0, 1); }), {"map"}));
  const BufferRef numbers = buffer("numbers", texels, Use::storage);
  EXPECT_TRUE(says(message([&] { device().read(numbers, 60, 8); }), {"numbers"}));
  EXPECT_TRUE(says(message([&] { device().upload(numbers, ~std::size_t{0}, bytes_of(texels)); }),
                   {"numbers"}));
  const PipelineRef pipeline = device().create(sampling());
  EXPECT_TRUE(says(drawing([&](Encoder& encoder) {
                     encoder.use(pipeline);
                     encoder.texture("map", {.texture = map, .level = 1, .level_count = 2},
                                     device().create(SamplerDesc{}));
                   }),
                   {"map"}));
}

TEST_P(Errors, textures_that_cannot_be) {
  const auto refused = [&](TextureDesc desc) {
    desc.label = "odd";
    const std::string text = message([&] { device().create(desc); });
    EXPECT_TRUE(says(text, {"odd"}));
    return text;
  };
  refused({.width = 0});
  refused({.height = -3});
  refused({.width = 4, .levels = 4});
  refused({.layers = 2});
  refused({.shape = Shape::cube, .width = 4, .height = 2});
  refused({.format = Format::none});
  refused({.format = Format::rgba8_srgb, .use = Use::storage});
  EXPECT_NE(message([&] { device().create(TextureDesc{}); }), ""); // no label
  EXPECT_NE(message([&] { device().create(BufferDesc{.label = "empty"}); }), "");
}

TEST_P(Errors, too_large_names_label_and_size) {
  const int most = device().max_texture_size();
  EXPECT_GE(most, 4096);
  EXPECT_TRUE(
      says(message([&] { device().create(TextureDesc{.label = "wide", .width = most + 1}); },
                   ExitCode::device),
           {"wide", std::to_string(most + 1)}));
  // 2^47 bytes and more: no machine has them.
  const std::size_t before = device().memory_bytes();
  EXPECT_TRUE(says(message(
                       [&] {
                         device().create(BufferDesc{"huge", std::size_t{1} << 47, Use::vertices});
                       },
                       ExitCode::device),
                   {"huge", std::to_string(std::size_t{1} << 47)}));
  EXPECT_TRUE(says(message(
                       [&] {
                         device().create(TextureDesc{.label = "thick",
                                                     .shape = Shape::d2_array,
                                                     .format = Format::rgba32f,
                                                     .width = most,
                                                     .height = most,
                                                     .layers = 2048});
                       },
                       ExitCode::device),
                   {"thick", "2048"}));
  EXPECT_EQ(device().memory_bytes(), before);
}

TEST_P(Errors, too_large_a_dispatch) {
  const BufferRef numbers = buffer("numbers", std::vector<float>(64), Use::storage);
  const PipelineRef pipeline = device().create(ComputeDesc{"add one", stage("add_one.comp"), {}});
  EXPECT_TRUE(says(
      message(
          [&] {
            run({.label = "tested", .writes_buffers = {numbers}, .record = [&](Encoder& encoder) {
                   encoder.use(pipeline);
                   encoder.buffer("Numbers", numbers);
                   encoder.dispatch(1, ~0u, 1);
                 }});
          },
          ExitCode::device),
      {"add one", "4294967295"}));
}

TEST_P(Errors, a_shader_that_does_not_compile_names_file_and_line) {
  PipelineDesc desc = sampling();
  desc.fragment = stage("bad.frag");
  EXPECT_TRUE(says(message([&] { device().create(desc); }), {"wrong.glsl:3", "undeclared"}));
}

TEST_P(Errors, constants_and_stages_that_do_not_belong) {
  PipelineDesc desc = sampling();
  desc.constants = {constant(77, 1)};
  EXPECT_TRUE(says(message([&] { device().create(desc); }), {"sampling", "77"}));
  desc = sampling();
  desc.fragment = stage("flat.frag"); // reads a vec4 where the vertex stage writes a vec2
  EXPECT_TRUE(says(message([&] { device().create(desc); }), {"sampling", "inColor"}));
  desc.fragment = stage("add_one.comp");
  EXPECT_TRUE(says(message([&] { device().create(desc); }), {"sampling"}));
}

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Errors, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
