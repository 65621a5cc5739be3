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
      copy_color_(device.create(gpu::PipelineDesc{.label = "backdrop color",
                                                  .vertex = "fullscreen.vert",
                                                  .fragment = "backdrop.frag",
                                                  .constants = {gpu::constant(0, false)},
                                                  .colors = {gpu::Format::rgba32f}})),
      halve_(device.create(gpu::PipelineDesc{.label = "pyramid",
                                             .vertex = "fullscreen.vert",
                                             .fragment = "pyramid.frag",
                                             .colors = {gpu::Format::rgba32f}})) {}

void Backdrop::add_passes(std::vector<gpu::Pass>& passes, const gpu::TextureRef& color,
                          const gpu::TextureRef& depth, bool with_depth, Draws& draws,
                          const std::vector<const Draw*>& foreground,
                          const std::function<void(gpu::Encoder&)>& begin) const {
  const auto level = [this](int l) { return gpu::View{pyramid_, l, 1, 0, 1}; };
  std::vector<gpu::ColorTarget> targets{{.view = level(0)}};
  if (with_depth) targets.push_back({.view = gpu::whole(depth_)});
  passes.push_back({.label = "backdrop",
                    .colors = targets,
                    .reads = {gpu::whole(color), gpu::whole(depth)},
                    .record = [this, color, depth, with_depth](gpu::Encoder& encoder) {
                      encoder.use(with_depth ? copy_ : copy_color_);
                      encoder.texture("sceneColor", gpu::whole(color), nearest_);
                      encoder.texture("sceneDepth", gpu::whole(depth), nearest_);
                      encoder.draw(3);
                    }});
  if (!foreground.empty()) {
    const DrawPass pass{.label = "foreground",
                        .fragment = "foreground.frag",
                        .colors = {gpu::Format::rgba32f},
                        .depth_write = false};
    std::vector<gpu::PipelineRef> pipelines;
    for (const Draw* draw : foreground)
      pipelines.push_back(draws.pipeline(pass, *draw));
    passes.push_back({.label = "foreground",
                      .colors = {{.view = level(0)}},
                      .depth = gpu::DepthTarget{.view = gpu::whole(depth)},
                      .reads = draws.sampled(),
                      .record = [=, &draws](gpu::Encoder& encoder) {
                        begin(encoder);
                        for (std::size_t i = 0; i < foreground.size(); ++i)
                          draws.record(encoder, pipelines[i], *foreground[i]);
                      }});
  }
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
