// What a draw does: where a triangle lands, which side it shows, what depth and blending make of
// it.
#include "gpu/fixture.h"

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

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Draw, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
