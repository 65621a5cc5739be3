#include "support/scene_pipelines.h"

#include "environment/stack.h"
#include "frame/renderer.h"
#include "scene/framing.h"
#include "support/recording_device.h"

namespace gg::test {

std::vector<gpu::PipelineDesc> pipelines_of(const scene::Scene& scene, needs::Method method) {
  RecordingDevice device;
  const gpu::TextureDesc cube{.shape = gpu::Shape::cube, .format = gpu::Format::rgba16f};
  const environment::Stack stack{.even = device.create(cube),
                                 .odd = device.create(cube),
                                 .irradiance = device.create(cube),
                                 .sampler = device.create(gpu::SamplerDesc{})};
  const frame::Renderer renderer(device, scene,
                                 {.width = 64,
                                  .height = 64,
                                  .samples = 1,
                                  .camera = scene::default_camera(scene, 1.0f),
                                  .environment = {.stack = &stack},
                                  .method = method});
  return device.pipelines;
}

} // namespace gg::test
