#include "frame/interior.h"

#include <array>

namespace gg::frame {
namespace {

constexpr gpu::Format texel_format = gpu::Format::rgba32ui;
constexpr std::uint32_t peels = 43; // constant of stages/interior.frag

constexpr const char* labels[] = {"interior F1", "interior B1", "interior F2", "interior B2"};

} // namespace

Interior::Interior(gpu::Device& device, int width, int height, int pairs)
    : layers_(device.create(
        gpu::TextureDesc{.label = "interior",
                         .shape = gpu::Shape::d2_array,
                         .format = texel_format,
                         .width = width,
                         .height = height,
                         .layers = 2 * pairs,
                         .use = gpu::Use::attachment | gpu::Use::sampled | gpu::Use::read_back})),
      depth_(device.create(gpu::TextureDesc{.label = "interior depth",
                                            .format = gpu::Format::depth32f,
                                            .width = width,
                                            .height = height,
                                            .use = gpu::Use::attachment})),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})) {}

gpu::Pass Interior::pass(Draws& draws, const std::vector<const needs::Draw*>& solids, int part,
                         const std::function<void(gpu::Encoder&)>& begin) const {
  const bool front = part % 2 == 0, peeling = part > 1;
  const DrawPass pass{.label = peeling ? "interior behind" : "interior",
                      .fragment = "interior.frag",
                      .colors = {texel_format},
                      .constants = {gpu::constant(peels, peeling)}};
  std::vector<gpu::PipelineRef> pipelines;
  for (const needs::Draw* solid : solids)
    pipelines.push_back(draws.pipeline(pass, *solid));
  std::vector<gpu::View> reads = draws.sampled();
  const gpu::View nearer{.texture = layers_, .layer = part - 2};
  if (peeling) reads.push_back(nearer);
  return {.label = labels[part],
          .colors = {{.view = {.texture = layers_, .layer = part},
                      .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}},
          .depth = gpu::DepthTarget{.view = gpu::whole(depth_), .clear = 0.0f},
          .reads = reads,
          .record = [=, this, &draws](gpu::Encoder& encoder) {
            begin(encoder);
            if (peeling) encoder.texture("nearer", nearer, nearest_);
            for (std::size_t i = 0; i < solids.size(); ++i)
              draws.record(encoder, pipelines[i], *solids[i],
                           front ? gpu::Cull::back : gpu::Cull::front);
          }};
}

void Interior::bind(gpu::Encoder& encoder) const {
  encoder.texture("interior", gpu::whole(layers_), nearest_);
}

} // namespace gg::frame
