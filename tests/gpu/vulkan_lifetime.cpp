// Objects in every order of going away; the validation layer tells of what is left behind.
#include "gpu/fixture.h"

namespace gg::gpu {
namespace {

constexpr DeviceDesc vulkan{.backend = Backend::vulkan, .debug = true};

// Everything a device makes, used once.
struct Everything {
  BufferRef vertices;
  TextureRef color;
  SamplerRef sampler;
  PipelineRef pipeline;

  explicit Everything(Device& device) {
    const std::vector<FlatVertex> triangle(3);
    vertices =
        device.create(BufferDesc{"vertices", triangle.size() * sizeof(FlatVertex), Use::vertices},
                      bytes_of(triangle));
    color = device.create(TextureDesc{.label = "colour",
                                      .width = 8,
                                      .height = 8,
                                      .levels = 2,
                                      .use = Use::attachment | Use::sampled});
    sampler = device.create(SamplerDesc{});
    pipeline = device.create(flat_pipeline(Format::rgba8));
    draw(device);
  }
  void draw(Device& device) const {
    const Pass pass{.label = "draw",
                    .colors = {{.view = {color}, .clear = {{0, 0, 0, 1}}}},
                    .record = [&](Encoder& encoder) {
                      encoder.use(pipeline);
                      encoder.vertices(0, vertices);
                      encoder.draw(3);
                    }};
    device.run(std::span(&pass, 1));
  }
};

// What is said on stderr while `function` runs and its devices go away.
template <typename Function>
std::string said_by(Function function) {
  testing::internal::CaptureStderr();
  function();
  return testing::internal::GetCapturedStderr();
}

TEST(vulkan_lifetime, nothing_is_left_behind) {
  EXPECT_EQ(said_by([] {
              const auto device = create_device(vulkan);
              const Everything all(*device);
            }),
            "");
}

TEST(vulkan_lifetime, objects_may_outlive_their_device) {
  EXPECT_EQ(said_by([] {
              std::optional<Everything> all;
              const auto device = create_device(vulkan);
              all.emplace(*device);
            }),
            "");
}

TEST(vulkan_lifetime, objects_may_go_while_the_device_works_with_them) {
  EXPECT_EQ(said_by([] {
              const auto device = create_device(vulkan);
              for (int i = 0; i < 20; ++i)
                const Everything brief(*device);
              device->finish();
            }),
            "");
}

TEST(vulkan_lifetime, memory_is_given_back) {
  const auto device = create_device(vulkan);
  EXPECT_EQ(device->memory_bytes(), 0u);
  {
    const Everything all(*device);
    EXPECT_GE(device->memory_bytes(), std::size_t{8 * 8 * 4});
  }
  EXPECT_EQ(device->memory_bytes(), 0u);
  device->finish();
  // Blocks are used again: many textures one after the other take no more than one of them.
  const auto before = device->counters().allocations;
  for (int i = 0; i < 100; ++i) {
    device->create(TextureDesc{.label = "brief", .width = 256, .height = 256});
    device->finish();
  }
  EXPECT_LE(device->counters().allocations, before + 1);
}

} // namespace
} // namespace gg::gpu
