// Textures: what goes in comes out, and what a sampler makes of it.
#include "gpu/fixture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace gg::gpu {
namespace {

using Vec4 = std::array<float, 4>;

// What bilinear weights of 8 bits (the least that Vulkan asks for) can be off by, of values up
// to 1.
constexpr float weight_error = 1.0f / 256.0f;

class Textures : public OnDevice {
protected:
  TextureRef filled(const TextureDesc& desc, const std::vector<float>& level_0) {
    const TextureRef texture = device().create(desc);
    device().upload(texture, 0, 0, bytes_of(level_0));
    return texture;
  }
  // Samples `map` over a target of the given size.
  std::vector<Vec4> sample(const View& map, const SamplerDesc& sampler, int width, int height,
                           const std::string& fragment = "sample.frag",
                           const std::vector<Constant>& constants = {}) {
    const TextureRef color = target("colour", Format::rgba32f, width, height);
    const SamplerRef made = device().create(sampler);
    fill(
        color, fragment, [&](Encoder& encoder) { encoder.texture("map", map, made); }, {map},
        constants);
    return read<Vec4>(color);
  }
};

constexpr SamplerDesc nearest = {.magnify = Filter::nearest, .minify = Filter::nearest};

TEST_P(Textures, every_format_comes_back_as_it_went_in) {
  std::mt19937 random(1);
  for (int i = static_cast<int>(Format::r8); i <= static_cast<int>(Format::depth32f); ++i) {
    const auto format = static_cast<Format>(i);
    const Use more = format == Format::depth32f ? Use::attachment : Use::sampled;
    const TextureRef texture = device().create(TextureDesc{.label = "format",
                                                           .format = format,
                                                           .width = 7, // odd rows: no padding
                                                           .height = 5,
                                                           .levels = 3,
                                                           .use = more | Use::read_back});
    for (int level = 0; level < 3; ++level) {
      const Extent size = extent(texture->desc, level);
      std::vector<std::byte> texels(static_cast<std::size_t>(size.width * size.height)
                                    * bytes_per_texel(format));
      // Any bits for integers; for floats a small exponent, since NaNs need not keep their bits;
      // and depths are in 0..1.
      for (std::byte& b : texels)
        b = static_cast<std::byte>(random() & 0xff);
      if (format == Format::depth32f || format == Format::r32f || format == Format::rg32f
          || format == Format::rgba32f)
        for (std::size_t j = 3; j < texels.size(); j += 4)
          texels[j] = std::byte{0x3e};
      if (format == Format::r16f || format == Format::rg16f || format == Format::rgba16f)
        for (std::size_t j = 1; j < texels.size(); j += 2)
          texels[j] &= std::byte{0x3f};
      device().upload(texture, level, 0, texels);
      EXPECT_EQ(device().read(texture, level, 0), texels) << "format " << i << ", level " << level;
    }
  }
}

TEST_P(Textures, each_layer_face_and_slice_is_its_own) {
  struct Case {
    Shape shape;
    int layers, count;
  };
  for (const Case& c : {Case{Shape::d2_array, 5, 5}, Case{Shape::d3, 5, 5}, Case{Shape::cube, 1, 6},
                        Case{Shape::cube_array, 2, 12}}) {
    const TextureRef texture = device().create(TextureDesc{.label = "layers",
                                                           .shape = c.shape,
                                                           .format = Format::rgba32f,
                                                           .width = 4,
                                                           .height = 4,
                                                           .layers = c.layers,
                                                           .levels = 2,
                                                           .use = Use::sampled | Use::read_back});
    for (int level = 0; level < 2; ++level) {
      const int count = extent(texture->desc, level).layers;
      EXPECT_EQ(count, c.shape == Shape::d3 && level == 1 ? 2 : c.count);
      const int side = 4 >> level;
      const auto texels = [&](int layer) {
        return std::vector<float>(static_cast<std::size_t>(4 * side * side),
                                  static_cast<float>(100 * level + layer));
      };
      for (int layer = 0; layer < count; ++layer)
        device().upload(texture, level, layer, bytes_of(texels(layer)));
      for (int layer = 0; layer < count; ++layer)
        EXPECT_EQ(read<float>(texture, level, layer), texels(layer));
    }
  }
}

TEST_P(Textures, srgb_texels_are_decoded) {
  const TextureRef map = device().create(
      TextureDesc{.label = "map", .format = Format::rgba8_srgb, .width = 256, .use = Use::sampled});
  std::vector<std::array<std::uint8_t, 4>> ramp(256);
  for (std::size_t i = 0; i < 256; ++i) {
    const auto v = static_cast<std::uint8_t>(i);
    ramp[i] = {v, v, v, v};
  }
  device().upload(map, 0, 0, bytes_of(ramp));
  const std::vector<Vec4> texels = sample(whole(map), nearest, 256, 1);
  for (std::size_t i = 0; i < 256; ++i) {
    // IEC 61966-2-1. llvmpipe decodes by a cubic that is up to 6e-4 off, so what is asked for is
    // what an 8-bit texel can mean: the light of its own code and of no other.
    const double linear = static_cast<double>(texels[i][0]);
    const double encoded =
        linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    EXPECT_NEAR(255.0 * encoded, static_cast<double>(i), 0.5);
    EXPECT_NEAR(255.0 * static_cast<double>(texels[i][3]), static_cast<double>(i),
                1e-3); // rounding
  }
}

TEST_P(Textures, row_0_is_at_coordinate_0) {
  const TextureRef map =
      filled({.label = "map", .format = Format::rgba32f, .width = 2, .height = 2},
             {1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0});
  const std::vector<Vec4> texels = sample(whole(map), nearest, 2, 2);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(texels[i][0], static_cast<float>(i + 1));
}

TEST_P(Textures, samplers_filter_and_wrap) {
  const TextureRef map =
      filled({.label = "map", .format = Format::r32f, .width = 4, .height = 1}, {0, 1, 2, 3});
  const auto row = [&](SamplerDesc sampler, float shift) {
    std::vector<float> values;
    for (const Vec4& texel : sample(whole(map), sampler, 4, 1, "sample.frag", {constant(1, shift)}))
      values.push_back(texel[0]);
    return values;
  };
  SamplerDesc sampler = nearest;
  using Row = std::vector<float>;
  EXPECT_EQ(row(sampler, 0.5f), (Row{2, 3, 3, 3})); // clamp
  sampler.u = Wrap::repeat;
  EXPECT_EQ(row(sampler, 0.5f), (Row{2, 3, 0, 1}));
  sampler.u = Wrap::mirrored_repeat;
  EXPECT_EQ(row(sampler, 0.5f), (Row{2, 3, 3, 2}));
  sampler = {};
  const Row half = row(sampler, 0.125f); // half a texel to the right
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(half[i], std::min(static_cast<float>(i) + 0.5f, 3.0f), weight_error) << i;
}

TEST_P(Textures, levels_are_chosen_and_mixed) {
  const TextureRef map = device().create(
      TextureDesc{.label = "map", .format = Format::r32f, .width = 4, .height = 4, .levels = 3});
  for (int level = 0; level < 3; ++level)
    device().upload(map, level, 0,
                    bytes_of(std::vector<float>(std::size_t{16} >> (2 * level),
                                                static_cast<float>(level + 1))));
  const auto at = [&](const View& view, const SamplerDesc& sampler, float level) {
    return sample(view, sampler, 1, 1, "sample.frag", {constant(0, level)})[0][0];
  };
  SamplerDesc mixing;
  mixing.between_levels = Filter::linear;
  EXPECT_EQ(at(whole(map), {}, 0.75f), 2.0f);
  EXPECT_NEAR(at(whole(map), mixing, 0.75f), 1.75f, weight_error);
  EXPECT_EQ(at(whole(map), mixing, 9.0f), 3.0f);
  SamplerDesc first_only = mixing;
  first_only.max_level = 0.0f;
  EXPECT_EQ(at(whole(map), first_only, 9.0f), 1.0f);
  // A view begins at its own level.
  EXPECT_EQ(at({.texture = map, .level = 1, .level_count = 1}, mixing, 5.0f), 2.0f);
  EXPECT_EQ(at({.texture = map, .level = 1, .level_count = 2}, mixing, 1.0f), 3.0f);
  EXPECT_EQ(at({.texture = map}, mixing, 5.0f), 1.0f);
}

TEST_P(Textures, a_view_may_be_a_layer_or_some_layers) {
  const TextureRef map = device().create(TextureDesc{.label = "map",
                                                     .shape = Shape::cube_array,
                                                     .format = Format::r32f,
                                                     .width = 1,
                                                     .height = 1,
                                                     .layers = 2});
  for (int layer = 0; layer < 12; ++layer)
    device().upload(map, 0, layer, bytes_of(std::vector{static_cast<float>(layer)}));
  EXPECT_EQ(sample({.texture = map, .layer = 7}, nearest, 1, 1)[0][0], 7.0f);
  const auto of_array = [&](const View& view, float layer) {
    return sample(view, nearest, 1, 1, "sample_array.frag", {constant(0, layer)})[0][0];
  };
  EXPECT_EQ(of_array(whole(map), 11.0f), 11.0f);
  EXPECT_EQ(of_array({.texture = map, .layer = 3, .layer_count = 4}, 2.0f), 5.0f);
}

TEST_P(Textures, a_volume_is_filtered_between_slices) {
  const TextureRef map = device().create(TextureDesc{
      .label = "map", .shape = Shape::d3, .format = Format::r32f, .width = 1, .layers = 4});
  for (int slice = 0; slice < 4; ++slice)
    device().upload(map, 0, slice, bytes_of(std::vector{static_cast<float>(slice)}));
  const auto at = [&](float w) {
    return sample(whole(map), {}, 1, 1, "sample_volume.frag", {constant(0, w)})[0][0];
  };
  EXPECT_NEAR(at(0.625f), 2.0f, weight_error);
  EXPECT_NEAR(at(0.5f), 1.5f, weight_error);
  EXPECT_NEAR(at(1.0f), 3.0f, weight_error);
}

TEST_P(Textures, integers_are_not_changed) {
  const TextureRef map = device().create(
      TextureDesc{.label = "map", .format = Format::rgba32ui, .width = 2, .height = 1});
  const std::vector<std::uint32_t> values = {0, 1, 0x7fffffff, 0xffffffff, 16777217, 5, 6, 7};
  device().upload(map, 0, 0, bytes_of(values));
  const TextureRef color = target("colour", Format::rgba32ui, 2, 1);
  const SamplerRef sampler = device().create(nearest);
  fill(color, "sample_integers.frag",
       [&](Encoder& encoder) { encoder.texture("map", whole(map), sampler); });
  EXPECT_EQ(read<std::uint32_t>(color), values);
}

TEST_P(Textures, mip_levels_are_means) {
  const TextureRef map =
      device().create(TextureDesc{.label = "map",
                                  .format = Format::rgba32f,
                                  .width = 8,
                                  .height = 4,
                                  .levels = 4,
                                  .use = Use::sampled | Use::attachment | Use::read_back});
  std::vector<float> texels(8 * 4 * 4);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<float>((i * i) % 31);
  device().upload(map, 0, 0, bytes_of(texels));
  device().generate_mipmaps(map);
  for (int level = 1; level < 4; ++level) {
    const Extent above = extent(map->desc, level - 1), here = extent(map->desc, level);
    const std::vector<float> fine = read<float>(map, level - 1), coarse = read<float>(map, level);
    for (int y = 0; y < here.height; ++y)
      for (int x = 0; x < here.width; ++x)
        for (int c = 0; c < 4; ++c) {
          float sum = 0.0f;
          for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx) {
              const int row = std::min(2 * y + dy, above.height - 1);
              sum += fine[static_cast<std::size_t>((row * above.width + 2 * x + dx) * 4 + c)];
            }
          EXPECT_NEAR(coarse[static_cast<std::size_t>((y * here.width + x) * 4 + c)], sum / 4.0f,
                      1e-5f * 31.0f) // rounding of a sum of four
              << "level " << level;
        }
  }
}

TEST_P(Textures, mip_levels_of_srgb_are_means_of_light) {
  const TextureRef map =
      device().create(TextureDesc{.label = "map",
                                  .format = Format::rgba8_srgb,
                                  .width = 2,
                                  .height = 2,
                                  .levels = 2,
                                  .use = Use::sampled | Use::attachment | Use::read_back});
  const std::vector<std::uint8_t> checker = {255, 255, 255, 255, 0,   0,   0,   255,
                                             0,   0,   0,   255, 255, 255, 255, 255};
  device().upload(map, 0, 0, bytes_of(checker));
  device().generate_mipmaps(map);
  // Half the light is 187.5 of 255 encoded; half the code would be 127.5.
  EXPECT_NEAR(read<std::uint8_t>(map, 1)[0], 187.5, 1.0);
}

// Cubes.

// The direction of a texel of a face, by the table that OpenGL and Vulkan share (OpenGL 4.5, table
// 8.19): s and t grow with column and row.
Vec4 direction(int face, float s, float t) {
  switch (face) {
  case 0:
    return {1, -t, -s, 0};
  case 1:
    return {-1, -t, s, 0};
  case 2:
    return {s, 1, t, 0};
  case 3:
    return {s, -1, -t, 0};
  case 4:
    return {s, -t, 1, 0};
  default:
    return {-s, -t, -1, 0};
  }
}

class Cubes : public Textures {
protected:
  std::vector<Vec4> look_up(const TextureRef& cube, const std::vector<Vec4>& directions,
                            const std::string& compute, const SamplerDesc& sampler) {
    const BufferRef asked = buffer("directions", directions, Use::storage);
    const BufferRef answers = buffer("colours", directions, Use::storage);
    const PipelineRef pipeline = device().create(ComputeDesc{compute, stage(compute), {}});
    run({.label = compute,
         .reads = {whole(cube)},
         .reads_buffers = {asked},
         .writes_buffers = {answers},
         .record = [&](Encoder& encoder) {
           encoder.use(pipeline);
           encoder.texture("map", whole(cube), device().create(sampler));
           encoder.buffer("Directions", asked);
           encoder.buffer("Colors", answers);
           encoder.dispatch(static_cast<std::uint32_t>(directions.size()), 1, 1);
         }});
    return read<Vec4>(answers);
  }
};

// A cube whose texels hold a running number.
std::vector<float> numbered_face(int face, int side) {
  std::vector<float> texels(static_cast<std::size_t>(side * side));
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<float>(face * side * side) + static_cast<float>(i);
  return texels;
}

TEST_P(Cubes, faces_lie_where_both_apis_define_them) {
  constexpr int side = 4;
  for (const bool array : {false, true}) {
    const TextureRef cube =
        device().create(TextureDesc{.label = "cube",
                                    .shape = array ? Shape::cube_array : Shape::cube,
                                    .format = Format::r32f,
                                    .width = side,
                                    .height = side,
                                    .layers = array ? 2 : 1});
    std::vector<Vec4> directions;
    for (int face = 0; face < 6; ++face) {
      device().upload(cube, 0, face + (array ? 6 : 0), bytes_of(numbered_face(face, side)));
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          directions.push_back(direction(face, (static_cast<float>(x) + 0.5f) / 2.0f - 1.0f,
                                         (static_cast<float>(y) + 0.5f) / 2.0f - 1.0f));
    }
    const std::vector<Vec4> found =
        look_up(cube, directions, array ? "sample_cubes.comp" : "sample_cube.comp", nearest);
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_EQ(found[i][0], static_cast<float>(i));
  }
}

TEST_P(Cubes, are_filtered_across_edges_and_corners) {
  const TextureRef cube = device().create(TextureDesc{
      .label = "cube", .shape = Shape::cube, .format = Format::r32f, .width = 2, .height = 2});
  for (int face = 0; face < 6; ++face)
    device().upload(cube, 0, face, bytes_of(std::vector<float>(4, face == 4 ? 1.0f : 0.0f)));
  // On the middle of each edge of +Z, half of the weight is on the neighbour, which is black; just
  // inside, a little more than half is on +Z.
  const std::vector<Vec4> found =
      look_up(cube, {{1, 0, 1, 0}, {-1, 0, 1, 0}, {0, 1, 1, 0}, {0, -1, 1, 0}, {0.75f, 0, 1, 0}},
              "sample_cube.comp", {});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(found[i][0], 0.5f, weight_error) << i;
  EXPECT_NEAR(found[4][0], 0.75f, weight_error);
}

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Textures, testing::ValuesIn(targets()), name_of);
INSTANTIATE_TEST_SUITE_P(gpu, Cubes, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
