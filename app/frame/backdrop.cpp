#include "frame/backdrop.h"

#include <algorithm>

namespace gg::frame {
namespace {

// The narrowest level is this many pixels across its shorter side: it stands for a blur as wide as the picture.
constexpr int least_size = 4;

int level_count(int width, int height) {
  int levels = 1;
  for (int size = std::min(width, height); size / 2 >= least_size; size /= 2)
    ++levels;
  return levels;
}

} // namespace

// Floats of 32 bits: a sun in the picture exceeds half floats, and its blur must not.
Backdrop::Backdrop(gpu::Device& device, int width, int height)
    : pyramid_(device.create(gpu::TextureDesc{.label = "screen pyramid",
                                              .format = gpu::Format::rgba32f,
                                              .width = width,
                                              .height = height,
                                              .levels = level_count(width, height),
                                              .use = gpu::Use::attachment | gpu::Use::sampled})),
      depth_(device.create(gpu::TextureDesc{.label = "backdrop depth",
                                            .format = gpu::Format::r32f,
                                            .width = width,
                                            .height = height,
                                            .use = gpu::Use::attachment | gpu::Use::sampled})),
      linear_(device.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear})),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})),
      copy_(device.create(gpu::PipelineDesc{.label = "backdrop",
                                            .vertex = "fullscreen.vert",
                                            .fragment = "backdrop.frag",
                                            .colors = {gpu::Format::rgba32f, gpu::Format::r32f}})),
      halve_(device.create(gpu::PipelineDesc{.label = "pyramid",
                                             .vertex = "fullscreen.vert",
                                             .fragment = "pyramid.frag",
                                             .colors = {gpu::Format::rgba32f}})) {}

void Backdrop::add_passes(std::vector<gpu::Pass>& passes, const gpu::TextureRef& color,
                          const gpu::TextureRef& depth, const UniformArray& layers,
                          std::size_t i) const {
  const auto level = [this](int l) { return gpu::View{pyramid_, l, 1, 0, 1}; };
  passes.push_back({.label = "backdrop",
                    .colors = {{.view = level(0)}, {.view = gpu::whole(depth_)}},
                    .reads = {gpu::whole(color), gpu::whole(depth)},
                    .record = [this, color, depth, layers, i](gpu::Encoder& encoder) {
                      encoder.use(copy_);
                      encoder.buffer("Layer", layers.buffer, layers.offset(i), layers.size);
                      encoder.texture("sceneColor", gpu::whole(color), nearest_);
                      encoder.texture("sceneDepth", gpu::whole(depth), nearest_);
                      encoder.draw(3);
                    }});
  for (int l = 1; l <= last_level(); ++l)
    passes.push_back({.label = "pyramid",
                      .colors = {{.view = level(l)}},
                      .reads = {level(l - 1)},
                      .record = [this, finer = level(l - 1)](gpu::Encoder& encoder) {
                        encoder.use(halve_);
                        encoder.texture("finer", finer, linear_);
                        encoder.draw(3);
                      }});
}

void Backdrop::bind(gpu::Encoder& encoder) const {
  encoder.texture("screenPyramid", gpu::whole(pyramid_), linear_);
  encoder.texture("backdropDepth", gpu::whole(depth_), nearest_);
}

std::vector<gpu::View> Backdrop::sampled() const {
  return {gpu::whole(pyramid_), gpu::whole(depth_)};
}

} // namespace gg::frame
