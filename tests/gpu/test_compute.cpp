// Compute passes: blocks, images, the order of passes.
#include "gpu/fixture.h"

namespace gg::gpu {
namespace {

class Compute : public OnDevice {};

struct Row {
  float a[4];
  std::uint32_t b[2];
  float c;
  float padding;
};
struct Settings {
  float scale[3];
  float offset;
  float table[3][4];
  std::uint32_t count;
  std::uint32_t padding[3];
};

TEST_P(Compute, blocks_hold_arrays_of_structures_and_know_their_length) {
  constexpr std::uint32_t count = 100; // no multiple of the group size
  std::vector<Row> rows(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    rows[i] = {{x, x + 1, x + 2, x + 3}, {i, 2 * i}, x / 2, 0};
  }
  const Settings settings{{1, 2, 3}, 4, {{10, 0, 0, 0}, {0, 20, 0, 0}, {0, 0, 30, 40}}, count, {}};
  const BufferRef uniforms = buffer("settings", std::vector{settings}, Use::uniforms);
  const BufferRef input = buffer("input", rows, Use::storage);
  const BufferRef output = buffer("output", std::vector<Row>(count), Use::storage);
  const PipelineRef pipeline = device().create(ComputeDesc{"square", stage("square.comp"), {}});
  run({.label = "square",
       .reads_buffers = {input},
       .writes_buffers = {output},
       .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         encoder.buffer("Settings", uniforms);
         encoder.buffer("Input", input);
         encoder.buffer("Output", output);
         encoder.buffer("NotThere", output); // ignored
         encoder.dispatch((count + 63) / 64, 1, 1);
       }});
  const std::vector<Row> results = read<Row>(output);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    const float* add = settings.table[i % 3];
    EXPECT_EQ(results[i].a[0], x + add[0]) << i;
    EXPECT_EQ(results[i].a[1], 2 * (x + 1) + add[1]) << i;
    EXPECT_EQ(results[i].a[2], 3 * (x + 2) + add[2]) << i;
    EXPECT_EQ(results[i].a[3], 4 * (x + 3) + add[3]) << i;
    EXPECT_EQ(results[i].b[0], i + count) << i;
    EXPECT_EQ(results[i].b[1], 3 * i) << i;
    EXPECT_EQ(results[i].c, x * x / 4) << i;
  }
}

// Images.

TEST_P(Compute, images_are_loaded_and_stored_in_their_own_format) {
  const auto doubled = [&](Format format, const std::string& compute, const auto& values) {
    const auto make = [&](const char* label) {
      return device().create(TextureDesc{
          .label = label, .format = format, .width = 2, .use = Use::storage | Use::read_back});
    };
    const TextureRef from = make("from"), to = make("to");
    device().upload(from, 0, 0, bytes_of(values));
    const PipelineRef pipeline = device().create(ComputeDesc{compute, stage(compute), {}});
    run({.label = compute, .storage = {{from}, {to}}, .record = [&](Encoder& encoder) {
           encoder.use(pipeline);
           encoder.image("from", {from});
           encoder.image("to", {to});
           encoder.dispatch(1, 1, 1);
         }});
    return values_of<typename std::decay_t<decltype(values)>::value_type>(device().read(to, 0, 0));
  };
  using Floats = std::vector<float>;
  using Integers = std::vector<std::uint32_t>;
  using Halves = std::vector<std::uint16_t>;
  EXPECT_EQ(doubled(Format::rgba32f, "double_rgba32f.comp", Floats{1, -2, 3, 4, 5, 6e30f, 7, 0.1f}),
            (Floats{2, -4, 6, 8, 10, 12e30f, 14, 0.2f}));
  EXPECT_EQ(doubled(Format::r32f, "double_r32f.comp", Floats{1.5f, -1e-30f}), (Floats{3, -2e-30f}));
  EXPECT_EQ(doubled(Format::r32ui, "double_r32ui.comp", Integers{3, 0x7fffffff}),
            (Integers{6, 0xfffffffe}));
  EXPECT_EQ(
      doubled(Format::rgba32ui, "double_rgba32ui.comp", Integers{1, 2, 3, 4, 5, 6, 7, 16777217}),
      (Integers{2, 4, 6, 8, 10, 12, 14, 33554434}));
  // Halves of 1, 2, 0.5, -1, 1024, the smallest that is not 0, 0 and 32752 (doubled: 65504, the
  // largest).
  EXPECT_EQ(doubled(Format::rgba16f, "double_rgba16f.comp",
                    Halves{0x3c00, 0x4000, 0x3800, 0xbc00, 0x6400, 0x0001, 0x0000, 0x77ff}),
            (Halves{0x4000, 0x4400, 0x3c00, 0xc000, 0x6800, 0x0002, 0x0000, 0x7bff}));
}

TEST_P(Compute, images_have_layers) {
  struct Case {
    Shape shape;
    int layers;
    std::uint32_t count;
    const char* compute;
  };
  for (const Case& c : {Case{Shape::cube, 1, 6, "layers_cube.comp"},
                        Case{Shape::d2_array, 3, 3, "layers_array.comp"},
                        Case{Shape::d3, 4, 4, "layers_volume.comp"}}) {
    const TextureRef to =
        device().create(TextureDesc{.label = c.compute,
                                    .shape = c.shape,
                                    .format = Format::rgba32f,
                                    .width = 4,
                                    .height = 4,
                                    .layers = c.layers,
                                    .levels = 2,
                                    .use = Use::storage | Use::sampled | Use::read_back});
    const PipelineRef pipeline = device().create(ComputeDesc{c.compute, stage(c.compute), {}});
    for (int level = 0; level < 2; ++level) {
      const Extent size = extent(to->desc, level);
      const View view{.texture = to, .level = level, .layer_count = size.layers};
      run({.label = c.compute, .storage = {view}, .record = [&](Encoder& encoder) {
             encoder.use(pipeline);
             encoder.image("to", view);
             encoder.dispatch(static_cast<std::uint32_t>(size.width),
                              static_cast<std::uint32_t>(size.height),
                              static_cast<std::uint32_t>(size.layers));
           }});
      for (int layer = 0; layer < size.layers; ++layer) {
        const auto texels = read<std::array<float, 4>>(to, level, layer);
        for (int y = 0; y < size.height; ++y)
          for (int x = 0; x < size.width; ++x)
            EXPECT_EQ(texels[static_cast<std::size_t>(y * size.width + x)],
                      (std::array{static_cast<float>(x), static_cast<float>(y),
                                  static_cast<float>(layer), 1.0f}))
                << c.compute << " level " << level;
      }
    }
  }
}

TEST_P(Compute, an_image_may_be_one_face_or_some_layers) {
  const TextureRef to = device().create(TextureDesc{.label = "to",
                                                    .shape = Shape::cube_array,
                                                    .format = Format::rgba32f,
                                                    .width = 2,
                                                    .height = 2,
                                                    .layers = 2,
                                                    .use = Use::storage | Use::read_back});
  const TextureRef from = device().create(TextureDesc{
      .label = "from", .format = Format::rgba32f, .width = 2, .height = 2, .use = Use::storage});
  device().upload(from, 0, 0, bytes_of(std::vector<float>(16, 4.0f)));
  const PipelineRef one = device().create(ComputeDesc{"one", stage("double_rgba32f.comp"), {}});
  const PipelineRef some = device().create(ComputeDesc{"some", stage("layers_cube.comp"), {}});
  const View face{.texture = to, .layer = 4};
  const View second{.texture = to, .layer = 6, .layer_count = 6};
  const std::vector<Pass> passes = {
      {.label = "one face",
       .storage = {{from}, face},
       .record =
           [&](Encoder& encoder) {
             encoder.use(one);
             encoder.image("from", {from});
             encoder.image("to", face);
             encoder.dispatch(1, 1, 1);
           }},
      {.label = "second cube", .storage = {second}, .record = [&](Encoder& encoder) {
         encoder.use(some);
         encoder.image("to", second);
         encoder.dispatch(2, 2, 6);
       }}};
  device().run(passes);
  EXPECT_EQ(read<float>(to, 0, 4), std::vector<float>(16, 8.0f));
  for (int layer = 6; layer < 12; ++layer)
    EXPECT_EQ(read<float>(to, 0, layer)[2], static_cast<float>(layer - 6));
}

// Order.

TEST_P(Compute, passes_see_what_earlier_passes_wrote) {
  constexpr int rounds = 50;
  const BufferRef numbers = buffer("numbers", std::vector<std::uint32_t>(1024), Use::storage);
  const PipelineRef pipeline = device().create(ComputeDesc{"add one", stage("add_one.comp"), {}});
  const Pass pass = {.label = "add one", .writes_buffers = {numbers}, .record = [&](Encoder& e) {
                       e.use(pipeline);
                       e.buffer("Numbers", numbers);
                       e.dispatch(16, 1, 1);
                     }};
  device().run(std::vector<Pass>(rounds, pass));
  EXPECT_EQ(read<std::uint32_t>(numbers), std::vector<std::uint32_t>(1024, rounds));
}

TEST_P(Compute, drawing_storing_and_sampling_follow_each_other) {
  const auto make = [&](const char* label) {
    return device().create(
        TextureDesc{.label = label,
                    .format = Format::rgba32f,
                    .width = 64,
                    .height = 64,
                    .use = Use::attachment | Use::storage | Use::sampled | Use::read_back});
  };
  const TextureRef a = make("a"), b = make("b");
  const SamplerRef sampler = device().create(SamplerDesc{});
  const PipelineRef add = device().create(ComputeDesc{"add", stage("add_to_image.comp"), {}});
  const PipelineRef copy = device().create(PipelineDesc{.label = "copy",
                                                        .vertex = stage("fullscreen.vert"),
                                                        .fragment = stage("sample.frag"),
                                                        .colors = {Format::rgba32f},
                                                        .cull = Cull::none});
  const Pass add_a_to_b = {
      .label = "add", .reads = {{a}}, .storage = {{b}}, .record = [&](Encoder& e) {
        e.use(add);
        e.texture("from", {a}, sampler);
        e.image("to", {b});
        e.dispatch(8, 8, 1);
      }};
  const Pass copy_b_to_a = {.label = "copy",
                            .colors = {{.view = {a}, .clear = {}}},
                            .reads = {{b}},
                            .record = [&](Encoder& e) {
                              e.use(copy);
                              e.texture("map", {b}, sampler);
                              e.draw(3);
                            }};
  std::vector<Pass> passes = {{.label = "one",
                               .colors = {{.view = {a}, .clear = {{1, 1, 1, 1}}}},
                               .record = [](Encoder&) {}},
                              {.label = "zero",
                               .colors = {{.view = {b}, .clear = {{0, 0, 0, 0}}}},
                               .record = [](Encoder&) {}}};
  constexpr int rounds = 10; // each doubles what both hold, after the first
  for (int i = 0; i < rounds; ++i) {
    passes.push_back(add_a_to_b);
    passes.push_back(copy_b_to_a);
  }
  device().run(passes);
  EXPECT_EQ(read<float>(a), std::vector<float>(64 * 64 * 4, 512.0f));
  EXPECT_EQ(read<float>(b), std::vector<float>(64 * 64 * 4, 512.0f));
}

TEST_P(Compute, a_buffer_written_by_a_shader_can_be_drawn_and_filled_again) {
  // Zero bits plus one, 0x3f800000 times, would be 1.0: instead the shader turns 0x3f7fffff into
  // it.
  std::vector<std::uint32_t> bits(64, 0x3f7fffffu);
  const BufferRef colors = buffer("colours", bits, Use::storage | Use::vertices);
  const PipelineRef pipeline = device().create(ComputeDesc{"add one", stage("add_one.comp"), {}});
  const PipelineRef squares =
      device().create(PipelineDesc{.label = "squares",
                                   .vertex = stage("indices.vert"),
                                   .fragment = stage("flat.frag"),
                                   .bindings = {{.stride = 0}},
                                   .attributes = {{.location = 0, .components = 4, .binding = 0},
                                                  {.location = 1, .components = 4, .binding = 0}},
                                   .colors = {Format::rgba32f},
                                   .cull = Cull::none});
  const TextureRef color = target("colour", Format::rgba32f, 4, 1);
  const std::vector<Pass> passes = {{.label = "add one",
                                     .writes_buffers = {colors},
                                     .record =
                                         [&](Encoder& e) {
                                           e.use(pipeline);
                                           e.buffer("Numbers", colors);
                                           e.dispatch(1, 1, 1);
                                         }},
                                    {.label = "draw",
                                     .colors = {{.view = {color}, .clear = {}}},
                                     .reads_buffers = {colors},
                                     .record = [&](Encoder& e) {
                                       e.use(squares);
                                       e.vertices(0, colors);
                                       e.draw(6, 4);
                                     }}};
  device().run(passes);
  EXPECT_EQ(read<float>(color), std::vector<float>(16, 1.0f));
  device().upload(colors, 4, bytes_of(std::vector<std::uint32_t>{5}));
  bits.assign(64, 0x3f800000u);
  bits[1] = 5;
  EXPECT_EQ(read<std::uint32_t>(colors), bits);
}

// Features.

TEST_P(Compute, constants_choose_features) {
  const TextureRef color = target("colour", Format::rgba32f, 2, 2);
  using Texel = std::array<float, 4>;
  const auto with = [&](const std::vector<Constant>& constants,
                        const std::function<void(Encoder&)>& bind = {}) {
    fill(color, "constants.frag", bind, {}, constants);
    return read<Texel>(color)[0];
  };
  // With the feature off nothing has to be bound for it.
  EXPECT_EQ(with({}), (Texel{0.5f, 7.0f, 0.5f, 0.0f}));
  EXPECT_EQ(with({constant(1, 3), constant(2, 1000u), constant(3, -1.25f)}),
            (Texel{-3.75f, 1000.0f, -1.25f, 0.0f}));
  const TextureRef map = device().create(TextureDesc{.label = "map", .format = Format::rgba32f});
  device().upload(map, 0, 0, bytes_of(std::vector<float>{1, 2, 3, 4}));
  const auto bind_map = [&](Encoder& encoder) {
    encoder.texture("map", whole(map), device().create(SamplerDesc{}));
  };
  EXPECT_EQ(with({constant(0, true)}, bind_map), (Texel{1.5f, 9.0f, 3.5f, 4.0f}));
  const BufferRef table = buffer("table", std::vector<float>{10, 20, 30, 40}, Use::uniforms);
  EXPECT_EQ(with({constant(0, true), constant(5, true)},
                 [&](Encoder& encoder) {
                   bind_map(encoder);
                   encoder.buffer("Table", table);
                 }),
            (Texel{11.5f, 29.0f, 33.5f, 44.0f}));
}

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Compute, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
