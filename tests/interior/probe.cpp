#include "interior/probe.h"

#include "frame/execution.h"
#include "frame/passes/passes.h"
#include "frame/uniform_array.h"
#include "needs/needs.h"
#include "uniforms/blocks.h"
#include "uniforms/camera.h"

#include <algorithm>
#include <cstring>

namespace gg::test {
namespace {

uniforms::FrameData frame_block(const ProbeDesc& desc) {
  const double aspect = static_cast<double>(desc.width) / desc.height;
  const glm::dmat4 clip =
      uniforms::clip_from_view(desc.camera, aspect) * uniforms::view_from_world(desc.camera);
  uniforms::FrameData f{};
  f.clipFromWorld = glm::mat4(clip);
  f.worldFromClip = glm::mat4(glm::inverse(clip));
  f.eye = glm::vec4(glm::vec3(desc.camera.world[3]), desc.camera.orthographic ? 0.0f : 1.0f);
  f.viewDirection = glm::vec4(-glm::normalize(glm::vec3(desc.camera.world[2])), 0.0f);
  return f;
}

std::vector<glm::vec4> texels(gpu::Device& device, const gpu::TextureRef& texture) {
  const std::vector<std::byte> bytes = device.read(texture, 0, 0);
  std::vector<glm::vec4> values(bytes.size() / sizeof(glm::vec4));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

} // namespace

ProbeResult probe(gpu::Device& device, const scene::Scene& scene, const ProbeDesc& desc,
                  int repeats) {
  const needs::Needs needs = needs::needs_of(
      scene, {.camera = desc.camera, .width = desc.width, .height = desc.height, .samples = 1});
  frame::UploadedScene uploaded(device);
  uploaded.set(needs);
  const tables::DeviceTables no_tables;
  frame::Draws draws(device, uploaded, no_tables);
  frame::UniformArray block, no_regions, no_shadows;
  frame::update_uniforms(device, block, "frame", std::vector{frame_block(desc)});
  const auto begin = [&](gpu::Encoder& encoder) {
    encoder.buffer("Frame", block.buffer, 0, block.size);
  };
  std::vector<const needs::Draw*> solids;
  for (const needs::Draw& draw : needs.draws.all)
    if (draw.is_solid()) solids.push_back(&draw);

  frame::Graph graph{.width = desc.width, .height = desc.height};
  for (int part = 0; part < 2 * desc.pairs; ++part)
    frame::declare_faces(graph, solids, part, desc.pairs);
  frame::Context context{device, needs, draws, no_regions, no_shadows};
  frame::Execution execution(device);
  execution.set(graph, context,
                {.bind = [&](gpu::Encoder& encoder, int) { begin(encoder); }, .reads = {}});
  std::vector<gpu::Pass> passes = execution.passes(0);
  const gpu::TextureRef faces = execution.texture("interior");
  const gpu::SamplerRef nearest = device.create(
      gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest});

  gpu::TextureRef targets[3];
  gpu::PipelineDesc pipeline{
      .label = "probe",
      .vertex = "fullscreen.vert",
      .fragment = std::string(GROUNDGLASS_SOURCE_DIR) + "/tests/interior/stages/exit_probe.frag",
      .constants = {gpu::constant(0, desc.pairs), gpu::constant(1, desc.bounces),
                    gpu::constant(2, scene.materials.front().ior), gpu::constant(3, desc.shown)},
      .cull = gpu::Cull::none};
  gpu::Pass pass{.label = "probe", .reads = {gpu::whole(faces)}};
  for (gpu::TextureRef& target : targets) {
    target = device.create(gpu::TextureDesc{.label = "probe",
                                            .format = gpu::Format::rgba32f,
                                            .width = desc.width,
                                            .height = desc.height,
                                            .use = gpu::Use::attachment | gpu::Use::read_back});
    pipeline.colors.push_back(gpu::Format::rgba32f);
    pass.colors.push_back({.view = gpu::whole(target), .clear = {}});
  }
  const gpu::PipelineRef search = device.create(pipeline);
  pass.record = [&](gpu::Encoder& encoder) {
    begin(encoder);
    encoder.use(search);
    encoder.texture("interior", gpu::whole(faces), nearest);
    encoder.draw(3);
  };
  passes.push_back(pass);

  ProbeResult result;
  for (int i = 0; i < repeats; ++i) {
    std::vector<gpu::PassTime> times;
    device.run(passes, &times);
    for (const gpu::PassTime& time : times) {
      const auto [at, is_new] = result.ms.try_emplace(time.label, time.ms);
      at->second = std::min(at->second, time.ms);
    }
  }
  const std::vector<glm::vec4> direction = texels(device, targets[0]),
                               first = texels(device, targets[1]),
                               rest = texels(device, targets[2]);
  for (std::size_t i = 0; i < direction.size(); ++i)
    result.pixels.push_back({.direction = glm::vec3(direction[i]),
                             .bounces = static_cast<int>(direction[i].w),
                             .met = glm::vec3(first[i]),
                             .reads = first[i].w,
                             .curvature = glm::vec2(rest[i]),
                             .share = rest[i].z,
                             .thickness = rest[i].w});
  for (int layer = 0; layer < 2 * desc.pairs; ++layer) {
    const std::vector<std::byte> bytes = device.read(faces, 0, layer);
    std::vector<std::uint32_t>& values = result.layers.emplace_back(bytes.size() / 4);
    std::memcpy(values.data(), bytes.data(), bytes.size());
  }
  return result;
}

} // namespace gg::test
