#include "gpu/fixture.h"

#include "support/devices.h"

#include <algorithm>

namespace gg::gpu {

std::string name_of(const testing::TestParamInfo<Target>& info) {
  if (info.param.backend == Backend::vulkan) return "vulkan";
  return info.param.surface == Surface::egl ? "opengl_egl" : "opengl_osmesa";
}

std::vector<Target> targets() {
  static const bool vulkan = std::ranges::any_of(
      list_devices(), [](const DeviceInfo& info) { return info.backend == "vulkan"; });
  std::vector<Target> result = {{Backend::opengl, Surface::egl},
                                {Backend::opengl, Surface::osmesa}};
  if (vulkan) result.push_back({Backend::vulkan, Surface::automatic});
  return result;
}

testing::AssertionResult says(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    if (message.find(part) == std::string::npos)
      return testing::AssertionFailure() << "'" << message << "' does not say '" << part << "'";
  return testing::AssertionSuccess();
}

std::string stage(const std::string& file) {
  return std::string(GROUNDGLASS_SOURCE_DIR) + "/tests/gpu/stages/" + file;
}

Device& OnDevice::device() {
  return test::shared_device(GetParam().backend, GetParam().surface);
}

TextureRef OnDevice::target(const std::string& label, Format format, int width, int height) {
  return device().create(TextureDesc{.label = label,
                                     .format = format,
                                     .width = width,
                                     .height = height,
                                     .use = Use::attachment | Use::sampled | Use::read_back});
}

void OnDevice::fill(const TextureRef& to, const std::string& fragment,
                    const std::function<void(Encoder&)>& bind, const std::vector<View>& reads,
                    const std::vector<Constant>& constants) {
  const PipelineRef pipeline = device().create(PipelineDesc{.label = fragment,
                                                            .vertex = stage("fullscreen.vert"),
                                                            .fragment = stage(fragment),
                                                            .constants = constants,
                                                            .colors = {to->desc.format},
                                                            .cull = Cull::none});
  run({.label = "fill",
       .colors = {{.view = {to}, .clear = {}}},
       .reads = reads,
       .record = [&](Encoder& encoder) {
         encoder.use(pipeline);
         if (bind) bind(encoder);
         encoder.draw(3);
       }});
}

PipelineDesc flat_pipeline(Format color) {
  return {.label = "flat",
          .vertex = stage("flat.vert"),
          .fragment = stage("flat.frag"),
          .bindings = {{.stride = sizeof(FlatVertex)}},
          .attributes = {{.location = 0, .components = 3, .binding = 0, .offset = 0},
                         {.location = 1,
                          .components = 4,
                          .binding = 0,
                          .offset = offsetof(FlatVertex, color)}},
          .colors = {color},
          .cull = Cull::none};
}

} // namespace gg::gpu
