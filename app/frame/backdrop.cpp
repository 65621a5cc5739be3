#include "frame/backdrop.h"

namespace gg::frame {

// Floats of 32 bits: a sun in the picture exceeds half floats, and its blur must not.
Backdrop::Backdrop(gpu::Device& device, const Desc& desc)
    : pyramid_(device.create(gpu::TextureDesc{.label = "screen pyramid",
                                              .format = gpu::Format::rgba32f,
                                              .width = desc.width,
                                              .height = desc.height,
                                              .levels = desc.levels,
                                              .use = gpu::Use::attachment | gpu::Use::sampled})),
      linear_(device.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear})),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})),
      copy_color_(device.create(gpu::PipelineDesc{.label = "backdrop color",
                                                  .vertex = "fullscreen.vert",
                                                  .fragment = "backdrop.frag",
                                                  .constants = {gpu::constant(0, false)},
                                                  .colors = {gpu::Format::rgba32f}})) {
  if (desc.levels > 1)
    halve_ = device.create(gpu::PipelineDesc{.label = "pyramid",
                                             .vertex = "fullscreen.vert",
                                             .fragment = "pyramid.frag",
                                             .colors = {gpu::Format::rgba32f}});
  const auto depth = [&](const char* name) {
    return device.create(gpu::TextureDesc{.label = name,
                                          .format = gpu::Format::r32f,
                                          .width = desc.width,
                                          .height = desc.height,
                                          .use = gpu::Use::attachment | gpu::Use::sampled});
  };
  if (desc.depth) depth_ = depth("backdrop depth");
  if (desc.glass_depth) glass_depth_ = depth("glass depth");
  if (!depth_ && !glass_depth_) return;
  copy_ = device.create(gpu::PipelineDesc{.label = "backdrop",
                                          .vertex = "fullscreen.vert",
                                          .fragment = "backdrop.frag",
                                          .colors = {gpu::Format::rgba32f, gpu::Format::r32f}});
}

gpu::Pass Backdrop::copy_pass(const gpu::TextureRef& color, const gpu::TextureRef& depth,
                              const needs::Pass& takes) const {
  std::vector<gpu::ColorTarget> targets{{.view = level(0)}};
  const bool takes_depth = takes.takes_depth || takes.glass_depth;
  if (takes_depth)
    targets.push_back({.view = gpu::whole(takes.takes_depth ? depth_ : glass_depth_)});
  return {.label = "backdrop",
          .colors = targets,
          .reads = {gpu::whole(color), gpu::whole(depth)},
          .record = [this, color, depth, takes_depth](gpu::Encoder& encoder) {
            encoder.use(takes_depth ? copy_ : copy_color_);
            encoder.texture("sceneColor", gpu::whole(color), nearest_);
            encoder.texture("sceneDepth", gpu::whole(depth), nearest_);
            encoder.draw(3);
          }};
}

gpu::Pass Backdrop::foreground_pass(const gpu::TextureRef& depth, Draws& draws,
                                    const std::vector<const needs::Draw*>& foreground,
                                    const std::function<void(gpu::Encoder&)>& begin) const {
  const DrawPass pass{.label = "foreground",
                      .fragment = "foreground.frag",
                      .colors = {gpu::Format::rgba32f},
                      .depth_write = false};
  std::vector<gpu::PipelineRef> pipelines;
  for (const needs::Draw* draw : foreground)
    pipelines.push_back(draws.pipeline(pass, *draw));
  return {.label = "foreground",
          .colors = {{.view = level(0)}},
          .depth = gpu::DepthTarget{.view = gpu::whole(depth)},
          .reads = draws.sampled(),
          .record = [=, &draws](gpu::Encoder& encoder) {
            begin(encoder);
            for (std::size_t i = 0; i < foreground.size(); ++i)
              draws.record(encoder, pipelines[i], *foreground[i]);
          }};
}

gpu::Pass Backdrop::level_pass(int l) const {
  return {.label = "pyramid",
          .colors = {{.view = level(l)}},
          .reads = {level(l - 1)},
          .record = [this, finer = level(l - 1)](gpu::Encoder& encoder) {
            encoder.use(halve_);
            encoder.texture("finer", finer, linear_);
            encoder.draw(3);
          }};
}

void Backdrop::bind(gpu::Encoder& encoder, bool behind_glass) const {
  encoder.texture("screenPyramid", gpu::whole(pyramid_), linear_);
  if (depth_) encoder.texture("backdropDepth", gpu::whole(depth_), nearest_);
  if (const gpu::TextureRef& hides = behind_glass ? glass_depth_ : depth_)
    encoder.texture("hidingDepth", gpu::whole(hides), nearest_);
}

std::vector<gpu::View> Backdrop::sampled() const {
  std::vector<gpu::View> views{gpu::whole(pyramid_)};
  if (depth_) views.push_back(gpu::whole(depth_));
  if (glass_depth_) views.push_back(gpu::whole(glass_depth_));
  return views;
}

} // namespace gg::frame
