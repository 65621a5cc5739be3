#include "frame/geometry_buffer.h"

namespace gg::frame {

GeometryBuffer::GeometryBuffer(gpu::Device& device, int width, int height)
    : texels_(device.create(gpu::TextureDesc{.label = "geometry",
                                             .format = texel_format,
                                             .width = width,
                                             .height = height,
                                             .use = gpu::Use::attachment | gpu::Use::sampled})),
      depth_(device.create(gpu::TextureDesc{.label = "material depth",
                                            .format = gpu::Format::depth32f,
                                            .width = width,
                                            .height = height,
                                            .use = gpu::Use::attachment})),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})),
      find_(device.create(gpu::PipelineDesc{.label = "material depth",
                                            .vertex = "region.vert",
                                            .fragment = "material_depth.frag",
                                            .depth = gpu::Format::depth32f,
                                            .depth_compare = gpu::Compare::always})) {}

gpu::ColorTarget GeometryBuffer::texels() const {
  return {.view = gpu::whole(texels_), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
}

gpu::Pass
GeometryBuffer::material_depth_pass(const gpu::TextureRef& scene_depth,
                                    const std::function<void(gpu::Encoder&)>& begin) const {
  return {.label = "material depth",
          .depth = gpu::DepthTarget{.view = gpu::whole(depth_), .clear = 0.0f},
          .reads = {sampled(), gpu::whole(scene_depth)},
          .record = [this, scene_depth, begin](gpu::Encoder& encoder) {
            encoder.use(find_);
            begin(encoder);
            bind(encoder);
            encoder.texture("sceneDepth", gpu::whole(scene_depth), nearest_);
            encoder.draw(6);
          }};
}

void GeometryBuffer::bind(gpu::Encoder& encoder) const {
  encoder.texture("geometry", sampled(), nearest_);
}

} // namespace gg::frame
