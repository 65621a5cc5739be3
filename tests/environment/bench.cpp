// How long a stack takes, beside the same levels by brute force on the same device in the same run. `ctest -L bench -V`.
#include "environment/support.h"
#include "environment/zonal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>

namespace gg::environment {
namespace {

using Clock = std::chrono::steady_clock;

glm::dvec3 landscape(const glm::dvec3& d) {
  const double sun = std::exp(800.0 * (glm::dot(d, glm::normalize(glm::dvec3(1, 0.6, 0.3))) - 1.0));
  return glm::dvec3(0.3 + std::max(d.y, 0.0)) + 2000.0 * sun * glm::dvec3(1.0, 0.9, 0.7)
         + 0.2 * std::sin(9.0 * d.x) * std::cos(7.0 * d.z);
}

double seconds_to_build(const Map& map, int times) {
  std::vector<double> seconds;
  for (int i = 0; i < times; ++i) {
    const auto start = Clock::now();
    const Stack stack = build(device(), map);
    device().finish();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  std::ranges::sort(seconds);
  return seconds[seconds.size() / 2];
}

// Every Gaussian level from the sharp one, over all pairs of texels, by environment_zonal.comp. Returns its time.
double brute_force(const Stack& stack, std::vector<CubeLevel>& results) {
  struct Step { // shaders/interface/environment_step.glsl
    std::int32_t sizes[4];
    float kernel[4];
  };
  const auto point = device().create(
      gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest});
  const auto pipeline =
      device().create(gpu::ComputeDesc{"brute force", "environment_zonal.comp", {}});
  const std::vector<Level> all = levels(stack);
  const int face = stack.even->desc.width;
  constexpr int samples = 16384; // the narrowest kernel is 0.01 wide
  std::vector<float> kernels;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto row =
        heat_kernel_table(all[i].sigma * all[i].sigma - all[0].sigma * all[0].sigma, samples);
    kernels.insert(kernels.end(), row.begin(), row.end());
  }
  const auto plane = [&](int width, int height, std::span<const float> values) {
    const auto texture = device().create(gpu::TextureDesc{
        .label = "plane", .format = gpu::Format::r32f, .width = width, .height = height});
    device().upload(texture, 0, 0, std::as_bytes(values));
    return texture;
  };
  const auto table = plane(samples, static_cast<int>(all.size()) - 1, kernels);
  std::vector<float> solid_angles;
  for (int i = 0; i < face * face; ++i)
    solid_angles.push_back(static_cast<float>(texel_solid_angle(i % face, i / face, face)));
  const auto areas = plane(face, face, solid_angles);
  std::vector<gpu::Pass> passes;
  std::vector<gpu::TextureRef> cubes;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const int size = all[i].cube->desc.width >> all[i].level;
    const Step step{{size, face, 0, 0}, {0.0f, 0.0f, static_cast<float>(i - 1), 0.0f}};
    const auto block = device().create(gpu::BufferDesc{"step", sizeof step, gpu::Use::uniforms},
                                       std::as_bytes(std::span(&step, 1)));
    cubes.push_back(
        device().create(gpu::TextureDesc{.label = "brute force",
                                         .shape = gpu::Shape::cube,
                                         .format = gpu::Format::rgba16f,
                                         .width = size,
                                         .height = size,
                                         .use = gpu::Use::storage | gpu::Use::read_back}));
    const gpu::View source{.texture = stack.even, .layer_count = 6},
        target{.texture = cubes.back(), .layer_count = 6};
    passes.push_back({.label = "brute force",
                      .reads = {source, gpu::whole(table), gpu::whole(areas)},
                      .storage = {target},
                      .record = [=](gpu::Encoder& encoder) {
                        const auto groups = static_cast<std::uint32_t>(
                            (size + 7) / 8); // 4 x 4 invocations of 2 x 2 texels
                        encoder.use(pipeline);
                        encoder.buffer("Step", block);
                        encoder.texture("source", source, point);
                        encoder.texture("kernels", gpu::whole(table), point);
                        encoder.texture("weights", gpu::whole(areas), point);
                        encoder.image("result", target);
                        encoder.dispatch(groups, groups, 6);
                      }});
  }
  device().finish();
  const auto start = Clock::now();
  device().run(passes);
  device().finish();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  for (const gpu::TextureRef& cube : cubes)
    results.push_back(read(*cube, 0, stack.unit));
  return seconds;
}

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The first stack of a process, as `capture` waits for it: shaders are compiled in it. Then once more without that, and the
// device's share by step. What the driver makes of the shaders Mesa keeps on the disk; MESA_SHADER_CACHE_DISABLE=true shows
// what a machine waits for that has never seen them.
void time_1k_map(gpu::Backend backend) {
  auto start = Clock::now();
  const auto device = gpu::create_device({.backend = backend});
  std::printf("    opening the device  %6.0f ms\n", ms_since(start));
  start = Clock::now();
  const Map map = load(std::filesystem::path(GROUNDGLASS_SOURCE_DIR)
                       / "assets/environments/studio_small_03_1k.hdr");
  std::printf("    reading the file    %6.0f ms\n", ms_since(start));
  for (const char* which : {"first in a process", "again"}) {
    start = Clock::now();
    const Stack stack = build(*device, map);
    device->finish();
    std::printf("    %-19s %6.0f ms\n", which, ms_since(start));
  }
  std::vector<gpu::PassTime> times;
  build(*device, map, &times);
  std::map<std::string, double> steps;
  for (const gpu::PassTime& time : times)
    steps[time.label] += time.ms;
  for (const auto& [label, ms] : steps)
    std::printf("    %-21s %4.0f ms on the device\n", label.c_str(), ms);
}

TEST(bench, a_1k_map_on_opengl) {
  time_1k_map(gpu::Backend::opengl);
}
TEST(bench, a_1k_map_on_vulkan) {
  time_1k_map(gpu::Backend::vulkan);
}

TEST(bench, stack_against_brute_force) {
  const Map small = picture_of(128, landscape);
  const Stack stack = build(device(), small);
  std::vector<CubeLevel> exact;
  const double slow = brute_force(stack, exact), fast = seconds_to_build(small, 3);
  const std::vector<Level> all = levels(stack);
  double pairs = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const CubeLevel level = read(*all[i].cube, all[i].level, stack.unit);
    double error = 0.0, norm = 0.0;
    for (std::size_t t = 0; t < level.texels.size(); ++t) {
      const glm::dvec3 d = level.texels[t] - exact[i - 1].texels[t];
      error += glm::dot(d, d);
      norm += glm::dot(exact[i - 1].texels[t], exact[i - 1].texels[t]);
    }
    pairs += static_cast<double>(level.texels.size());
    std::printf("    sigma %.4f  relative RMSE against brute force %.5f\n", all[i].sigma,
                std::sqrt(error / norm));
    EXPECT_LT(std::sqrt(error / norm), 0.01);
  }
  const int face = stack.even->desc.width;
  const double rate = pairs * 6.0 * face * face / slow;
  std::printf("    128 x 64:    stack %.3f s, brute force %.3f s (%.0f million pairs a second)\n",
              fast, slow, rate / 1e6);
  const double large = seconds_to_build(picture_of(1024, landscape), 3);
  std::printf("    1024 x 512:  stack %.3f s, brute force at that rate %.0f s\n", large,
              4096.0 * slow);
}

} // namespace
} // namespace gg::environment
