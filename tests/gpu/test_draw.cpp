// What a draw does: where a triangle lands, which side it shows, what depth and blending make of
// it.
#include "gpu/fixture.h"

#include <algorithm>

namespace gg::gpu {
namespace {

using Rgba = std::array<std::uint8_t, 4>;
constexpr Rgba black = {0, 0, 0, 255}, red = {255, 0, 0, 255}, green = {0, 255, 0, 255};

// A triangle in the upper left of the picture, seen counter-clockwise: left, bottom, right.
const std::vector<FlatVertex> upper_left = {{{-1.0f, 1.0f, 0.5f}, {1, 0, 0, 1}},
                                            {{-1.0f, 0.0f, 0.5f}, {1, 0, 0, 1}},
                                            {{1.0f, 1.0f, 0.5f}, {1, 0, 0, 1}}};

class Draw : public OnDevice {
protected:
  static constexpr int width = 16, height = 8;

  std::vector<Rgba> draw(const PipelineDesc& desc, const std::vector<FlatVertex>& triangles,
                         const std::function<void(Encoder&)>& before = {}) {
    const TextureRef color = target("colour", desc.colors.front(), width, height);
    const BufferRef vertices = buffer("vertices", triangles, Use::vertices);
    const PipelineRef pipeline = device().create(desc);
    std::optional<DepthTarget> depth;
    if (desc.depth != Format::none)
      depth = DepthTarget{{target("depth", desc.depth, width, height)}, 0.0f};
    run({.label = "draw",
         .colors = {{.view = {color}, .clear = {{0, 0, 0, 1}}}},
         .depth = depth,
         .record = [&](Encoder& encoder) {
           encoder.use(pipeline);
           encoder.vertices(0, vertices);
           if (before) before(encoder);
           encoder.draw(static_cast<std::uint32_t>(triangles.size()));
         }});
    return read<Rgba>(color);
  }
};

TEST_P(Draw, row_0_is_the_top_and_x_goes_right) {
  const std::vector<Rgba> picture = draw(flat_pipeline(Format::rgba8), upper_left);
  const auto at = [&](int x, int y) { return picture[static_cast<std::size_t>(y * width + x)]; };
  EXPECT_EQ(at(0, 0), red);
  EXPECT_EQ(at(width - 3, 0), red);
  EXPECT_EQ(at(0, height / 2 - 1), red);
  EXPECT_EQ(at(width - 1, height / 2 - 1), black); // beyond the hypotenuse
  EXPECT_EQ(at(0, height / 2), black);
  EXPECT_EQ(at(0, height - 1), black);
}

TEST_P(Draw, counter_clockwise_is_the_front) {
  PipelineDesc desc = flat_pipeline(Format::rgba8);
  desc.cull = Cull::back;
  EXPECT_EQ(draw(desc, upper_left)[0], red);
  desc.cull = Cull::front;
  EXPECT_EQ(draw(desc, upper_left)[0], black);
}

TEST_P(Draw, a_mirrored_instance_turns_its_front_round) {
  PipelineDesc desc = flat_pipeline(Format::rgba8);
  desc.cull = Cull::back;
  EXPECT_EQ(draw(desc, upper_left, [](Encoder& e) { e.front_is_clockwise(true); })[0], black);
  EXPECT_EQ(draw(desc, upper_left,
                 [](Encoder& e) {
                   e.front_is_clockwise(true);
                   e.cull(Cull::front);
                 })[0],
            red);
}

TEST_P(Draw, indices_start_where_they_are_told) {
  std::vector<FlatVertex> vertices = upper_left;
  for (FlatVertex vertex : upper_left) {
    vertex.position[1] = -vertex.position[1]; // mirrored into the lower half
    vertices.push_back(vertex);
  }
  const TextureRef color = target("colour", Format::rgba8, width, height);
  const BufferRef points = buffer("points", vertices, Use::vertices);
  const BufferRef order =
      buffer("order", std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, Use::indices);
  const PipelineRef pipeline = device().create(flat_pipeline(Format::rgba8));
  run({.label = "draw",
       .colors = {{.view = {color}, .clear = {{0, 0, 0, 1}}}},
       .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         encoder.vertices(0, points);
         encoder.indices(order);
         encoder.draw_indexed(3, 1, 3);
       }});
  const std::vector<Rgba> picture = read<Rgba>(color);
  EXPECT_EQ(picture[0], black);
  EXPECT_EQ(picture[(height - 1) * width], red);
}

TEST_P(Draw, vertices_start_at_their_offset) {
  std::vector<FlatVertex> vertices(3, FlatVertex{{-1, 1, 0.5f}, {0, 0, 1, 1}});
  vertices.insert(vertices.end(), upper_left.begin(), upper_left.end());
  const TextureRef color = target("colour", Format::rgba8, width, height);
  const BufferRef points = buffer("points", vertices, Use::vertices);
  const PipelineRef pipeline = device().create(flat_pipeline(Format::rgba8));
  run({.label = "draw",
       .colors = {{.view = {color}, .clear = {{0, 0, 0, 1}}}},
       .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         encoder.vertices(0, points, 3 * sizeof(FlatVertex));
         encoder.draw(3);
       }});
  EXPECT_EQ(read<Rgba>(color)[0], red);
}

TEST_P(Draw, vertex_and_instance_indices_count_from_zero) {
  const TextureRef color = target("colour", Format::rgba8, 4, 1);
  const std::vector<std::array<float, 4>> per_instance = {{1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 1, 1}};
  const std::vector<std::array<float, 4>> shared = {{1, 1, 0, 1}};
  const BufferRef colors = buffer("colours", per_instance, Use::vertices);
  const BufferRef filter = buffer("filter", shared, Use::vertices);
  const PipelineRef pipeline = device().create(
      PipelineDesc{.label = "squares",
                   .vertex = stage("indices.vert"),
                   .fragment = stage("flat.frag"),
                   .bindings = {{.stride = 16, .step = Step::instance}, {.stride = 0}},
                   .attributes = {{.location = 0, .components = 4, .binding = 0},
                                  {.location = 1, .components = 4, .binding = 1}},
                   .colors = {Format::rgba8},
                   .cull = Cull::none});
  run({.label = "draw",
       .colors = {{.view = {color}, .clear = {{0, 0, 0, 1}}}},
       .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         encoder.vertices(0, colors);
         encoder.vertices(1, filter);
         encoder.draw(6, 3);
       }});
  EXPECT_EQ(read<Rgba>(color), (std::vector<Rgba>{red, green, {255, 255, 0, 255}, black}));
}

// Two triangles over each other: red at `first`, then green at `second`.
std::vector<FlatVertex> stacked(float first, float second) {
  std::vector<FlatVertex> both = upper_left;
  for (FlatVertex& vertex : both)
    vertex.position[2] = first;
  for (FlatVertex vertex : upper_left) {
    vertex.position[2] = second;
    std::swap(vertex.color[0], vertex.color[1]);
    both.push_back(vertex);
  }
  return both;
}

TEST_P(Draw, larger_depth_is_nearer) {
  PipelineDesc desc = flat_pipeline(Format::rgba8);
  desc.depth = Format::depth32f;
  EXPECT_EQ(draw(desc, stacked(0.75f, 0.25f))[0], red);
  EXPECT_EQ(draw(desc, stacked(0.25f, 0.75f))[0], green);
  desc.depth_write = false;
  EXPECT_EQ(draw(desc, stacked(0.75f, 0.25f))[0], green);
  desc.depth_write = true;
  desc.depth_compare = Compare::always;
  EXPECT_EQ(draw(desc, stacked(0.75f, 0.25f))[0], green);
}

TEST_P(Draw, depth_is_what_clip_space_says) {
  const TextureRef depth = target("depth", Format::depth32f, width, height);
  PipelineDesc desc = flat_pipeline(Format::none);
  desc.colors.clear();
  desc.depth = Format::depth32f;
  const BufferRef points = buffer("points", stacked(0.25f, 0.125f), Use::vertices);
  const PipelineRef pipeline = device().create(desc);
  run({.label = "depth", .depth = DepthTarget{{depth}, 0.0f}, .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         encoder.vertices(0, points);
         encoder.draw(6);
       }});
  const std::vector<float> values = read<float>(depth);
  EXPECT_EQ(values.front(), 0.25f);
  EXPECT_EQ(values.back(), 0.0f);
}

TEST_P(Draw, over_expects_premultiplied_colour_and_add_adds) {
  // A quarter of blue over half of red, which hides all of the black clear colour.
  std::vector<FlatVertex> layers = stacked(0.5f, 0.5f);
  for (std::size_t i = 3; i < 6; ++i)
    std::ranges::copy(std::array{0.0f, 0.0f, 0.25f, 0.25f}, layers[i].color);
  for (std::size_t i = 0; i < 3; ++i)
    layers[i].color[0] = 0.5f;
  PipelineDesc desc = flat_pipeline(Format::rgba32f);
  const auto blended = [&](Blend blend) {
    desc.blend = blend;
    const TextureRef color = target("colour", Format::rgba32f, 2, 2);
    const BufferRef points = buffer("points", layers, Use::vertices);
    const PipelineRef pipeline = device().create(desc);
    run({.label = "blend",
         .colors = {{.view = {color}, .clear = {{0, 0, 0, 0}}}},
         .record = [&](Encoder& encoder) {
           encoder.use(pipeline);
           encoder.vertices(0, points);
           encoder.draw(6);
         }});
    return read<std::array<float, 4>>(color)[0];
  };
  EXPECT_EQ(blended(Blend::none), (std::array{0.0f, 0.0f, 0.25f, 0.25f}));
  EXPECT_EQ(blended(Blend::over), (std::array{0.375f, 0.0f, 0.25f, 1.0f}));
  EXPECT_EQ(blended(Blend::add), (std::array{0.5f, 0.0f, 0.25f, 1.25f}));
}

TEST_P(Draw, what_is_not_cleared_is_kept) {
  const TextureRef color = target("colour", Format::rgba32f, 4, 4);
  const std::vector<float> before(64, 3.5f);
  device().upload(color, 0, 0, bytes_of(before));
  run({.label = "nothing", .colors = {{.view = {color}, .clear = {}}}, .record = [](Encoder&) {}});
  EXPECT_EQ(read<float>(color), before);
  run({.label = "clear",
       .colors = {{.view = {color}, .clear = {{1, 2, 3, 4}}}},
       .record = [](Encoder&) {}});
  EXPECT_EQ(read<float>(color)[5], 2.0f);
}

TEST_P(Draw, an_srgb_target_encodes) {
  std::vector<FlatVertex> half = upper_left;
  for (FlatVertex& vertex : half)
    vertex.color[0] = 0.5f;
  // 0.5 encoded by IEC 61966-2-1: 1.055 * 0.5^(1/2.4) - 0.055 = 0.7354, times 255.
  EXPECT_NEAR(draw(flat_pipeline(Format::rgba8_srgb), half)[0][0], 187.5, 0.6);
  EXPECT_NEAR(draw(flat_pipeline(Format::rgba8), half)[0][0], 127.5, 0.6);
}

TEST_P(Draw, fragment_coordinates_and_derivatives_count_from_row_0) {
  const TextureRef color = target("colour", Format::rgba32f, 8, 4);
  fill(color, "coordinates.frag");
  const auto texels = read<std::array<float, 4>>(color);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) {
      const std::array<float, 4>& texel = texels[static_cast<std::size_t>(y * 8 + x)];
      EXPECT_EQ(texel[0], static_cast<float>(x) + 0.5f);
      EXPECT_EQ(texel[1], static_cast<float>(y) + 0.5f);
      // Rounding of the interpolated coordinate, in units of its largest value.
      EXPECT_NEAR(texel[2], 1.0f / 8.0f, 1e-6f);
      EXPECT_NEAR(texel[3], 1.0f / 4.0f, 1e-6f);
    }
}

TEST_P(Draw, two_targets_of_different_formats) {
  const TextureRef first = target("first", Format::rgba8, 4, 4);
  const TextureRef second = target("second", Format::rg32ui, 4, 4);
  const PipelineRef pipeline =
      device().create(PipelineDesc{.label = "two",
                                   .vertex = stage("fullscreen.vert"),
                                   .fragment = stage("two_targets.frag"),
                                   .colors = {Format::rgba8, Format::rg32ui},
                                   .cull = Cull::none});
  run({.label = "two",
       .colors = {{.view = {first}, .clear = {}}, {.view = {second}, .clear = {{7, 7, 7, 7}}}},
       .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         encoder.draw(3);
       }});
  EXPECT_EQ(read<Rgba>(first)[0], (Rgba{32, 32, 64, 255}));
  EXPECT_EQ((read<std::array<std::uint32_t, 2>>(second)[4 * 2 + 3]),
            (std::array<std::uint32_t, 2>{3, 2}));
}

TEST_P(Draw, into_a_level_and_a_face) {
  const TextureRef cube =
      device().create(TextureDesc{.label = "cube",
                                  .shape = Shape::cube,
                                  .format = Format::rgba32f,
                                  .width = 8,
                                  .height = 8,
                                  .levels = 2,
                                  .use = Use::attachment | Use::sampled | Use::read_back});
  for (int level = 0; level < 2; ++level)
    for (int face = 0; face < 6; ++face)
      run({.label = "clear",
           .colors = {{.view = {.texture = cube, .level = level, .layer = face},
                       .clear = {{static_cast<float>(level), static_cast<float>(face), 0, 0}}}},
           .record = [](Encoder&) {}});
  for (int level = 0; level < 2; ++level)
    for (int face = 0; face < 6; ++face) {
      const std::vector<float> texels = read<float>(cube, level, face);
      EXPECT_EQ(texels.size(), level == 0 ? 256u : 64u);
      EXPECT_EQ(texels[0], static_cast<float>(level));
      EXPECT_EQ(texels.back() + texels[texels.size() - 3], static_cast<float>(face));
    }
}

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Draw, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
