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

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Compute, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
