// A frame that is drawn again makes nothing new.
#include "gpu/fixture.h"

namespace gg::gpu {
namespace {

class Steady : public OnDevice {};

// Upload, draw into one texture, sample it into another, compute from that into a buffer: the kinds
// of work that a frame is made of.
TEST_P(Steady, frames_create_allocate_and_compile_nothing) {
  const TextureRef first = target("first", Format::rgba8, 16, 16);
  const TextureRef second = target("second", Format::rgba8, 16, 16);
  const BufferRef vertices = buffer("vertices", std::vector<FlatVertex>(3), Use::vertices);
  const SamplerRef sampler = device().create(SamplerDesc{});
  const PipelineRef flat = device().create(flat_pipeline(Format::rgba8));
  const PipelineRef sample = device().create(PipelineDesc{.label = "sample",
                                                          .vertex = stage("fullscreen.vert"),
                                                          .fragment = stage("sample.frag"),
                                                          .colors = {Format::rgba8},
                                                          .cull = Cull::none});
  const std::vector<Pass> passes{{.label = "draw",
                                  .colors = {{.view = {first}, .clear = {{0, 0, 0, 1}}}},
                                  .record =
                                      [&](Encoder& encoder) {
                                        encoder.use(flat);
                                        encoder.vertices(0, vertices);
                                        for (int i = 0; i < 10; ++i)
                                          encoder.draw(3);
                                      }},
                                 {.label = "sample",
                                  .colors = {{.view = {second}, .clear = {{0, 0, 0, 1}}}},
                                  .reads = {{first}},
                                  .record = [&](Encoder& encoder) {
                                    encoder.use(sample);
                                    encoder.texture("map", {first}, sampler);
                                    encoder.draw(3);
                                  }}};
  const std::vector<FlatVertex> moved(3);
  const auto frame = [&] {
    device().upload(vertices, 0, bytes_of(moved));
    device().run(passes);
  };
  for (int i = 0; i < 2; ++i)
    frame();
  const DeviceCounters before = device().counters();
  constexpr int frames = 50;
  for (int i = 0; i < frames; ++i)
    frame();
  const DeviceCounters after = device().counters();
  EXPECT_EQ(after.created, before.created);
  EXPECT_EQ(after.allocations, before.allocations);
  EXPECT_EQ(after.compiled, before.compiled);
  EXPECT_EQ(after.submissions, before.submissions + frames);
  EXPECT_EQ(after.passes, before.passes + 2 * frames);
  EXPECT_EQ(after.draws, before.draws + 11 * frames);
  EXPECT_EQ(after.dispatches, before.dispatches);
  EXPECT_GT(after.record_ms, before.record_ms);
}

} // namespace

INSTANTIATE_TEST_SUITE_P(gpu, Steady, testing::ValuesIn(targets()), name_of);

} // namespace gg::gpu
