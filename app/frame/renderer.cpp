#include "frame/renderer.h"

#include "environment/stack.h"
#include "frame/camera.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gg::frame {
namespace {

// Scene colour keeps radiance beyond half-float range (a sun through a hole in the clouds is above
// 100,000).
constexpr gpu::Format color_format = gpu::Format::rgba32f;
constexpr gpu::Format depth_format = gpu::Format::depth32f;

} // namespace

Renderer::Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc)
    : device_(device), desc_(desc), uploaded_(device, scene), tables_(wanted_tables()),
      draws_(device, uploaded_, tables_, features(), desc.camera),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})) {
  make_targets();
  make_frame_blocks();
  make_passes();
}

Renderer::~Renderer() = default;

tables::DeviceTables Renderer::wanted_tables() const {
  std::vector<tables::Model> wanted;
  if (desc_.environment.stack)
    for (const scene::Material& material : uploaded_.scene().materials)
      if (!material.unlit) wanted.push_back(model_of(material, desc_.correlated_smith));
  return tables::upload(device_, wanted);
}

FrameFeatures Renderer::features() const {
  return {.method = desc_.method,
          .correlated_smith = desc_.correlated_smith,
          .multiple_scattering = desc_.multiple_scattering,
          .environment = desc_.environment.stack != nullptr,
          .lights = !uploaded_.scene().lights.empty()};
}

void Renderer::make_targets() {
  const auto target = [&](const char* label, gpu::Format format, gpu::Use use) {
    return device_.create(gpu::TextureDesc{.label = label,
                                           .format = format,
                                           .width = desc_.width,
                                           .height = desc_.height,
                                           .use = gpu::Use::attachment | use});
  };
  color_ = target("scene color", color_format, gpu::Use::sampled | gpu::Use::read_back);
  depth_ = target("scene depth", depth_format, gpu::Use::attachment);
  if (desc_.samples > 1) average_ = target("average", color_format, gpu::Use::read_back);
}

void Renderer::make_frame_blocks() {
  const scene::Camera& camera = desc_.camera;
  const double aspect = static_cast<double>(desc_.width) / desc_.height;
  const glm::dmat4 clip_from_world = clip_from_view(camera, aspect) * view_from_world(camera);
  std::vector<FrameData> frames;
  for (int i = 0; i < desc_.samples; ++i) {
    const glm::dvec2 at = sample_position(i, desc_.samples);
    const glm::dmat4 clip =
        offset_by_pixels(at.x, at.y, desc_.width, desc_.height) * clip_from_world;
    FrameData f{};
    f.clipFromWorld = glm::mat4(clip);
    f.worldFromClip = glm::mat4(glm::inverse(clip));
    f.eye = glm::vec4(glm::vec3(camera.world[3]), camera.orthographic ? 0.0f : 1.0f);
    f.viewDirection = glm::vec4(-glm::normalize(glm::vec3(camera.world[2])), 0.0f);
    f.environment = {std::cos(desc_.environment.rotation), std::sin(desc_.environment.rotation),
                     desc_.environment.intensity, 0.0f};
    if (desc_.environment.stack) f.stack = desc_.environment.stack->shape;
    f.counts = {static_cast<int>(uploaded_.scene().lights.size()), 0, 0, 0};
    frames.push_back(f);
  }
  frames_ = upload_uniforms(device_, "frame", frames);
}

void Renderer::bind_environment(gpu::Encoder& encoder) const {
  const environment::Stack& stack = *desc_.environment.stack;
  encoder.texture("stackEven", gpu::whole(stack.even), stack.sampler);
  encoder.texture("stackOdd", gpu::whole(stack.odd), stack.sampler);
  encoder.texture("irradianceCube", gpu::whole(stack.irradiance), stack.sampler);
}

void Renderer::record_sky(gpu::Encoder& encoder) const {
  encoder.use(sky_);
  encoder.draw(3);
}

std::vector<gpu::View> Renderer::sampled() const {
  std::vector<gpu::View> views = draws_.sampled();
  if (const environment::Stack* stack = desc_.environment.stack)
    for (const gpu::TextureRef& cube : {stack->even, stack->odd, stack->irradiance})
      views.push_back(gpu::whole(cube));
  return views;
}

std::vector<Renderer::Recorded> Renderer::recorded(Role role, const DrawPass& pass) {
  std::vector<Recorded> result;
  for (const Draw* draw : draws_.of(role))
    result.push_back({draw, draws_.pipeline(pass, *draw)});
  return result;
}

void Renderer::make_passes() {
  if (desc_.environment.stack)
    sky_ = device_.create(gpu::PipelineDesc{.label = "sky",
                                            .vertex = "fullscreen.vert",
                                            .fragment = "sky.frag",
                                            .colors = {color_format},
                                            .depth = depth_format,
                                            .depth_write = false});
  if (desc_.samples > 1)
    accumulate_ = device_.create(
        gpu::PipelineDesc{.label = "accumulate",
                          .vertex = "fullscreen.vert",
                          .fragment = "accumulate.frag",
                          .constants = {gpu::constant(0, 1.0f / static_cast<float>(desc_.samples))},
                          .colors = {color_format},
                          .blend = gpu::Blend::add});

  const DrawPass opaque{.label = "opaque", .fragment = "opaque.frag", .colors = {color_format}};
  opaque_ = recorded(Role::opaque, opaque);
  for (const Recorded& glass : recorded(Role::refractive, opaque))
    opaque_.push_back(glass);
  blended_ = recorded(Role::blended, {.label = "blended",
                                      .fragment = "opaque.frag",
                                      .colors = {color_format},
                                      .depth_write = false,
                                      .blend = gpu::Blend::over});
  const std::vector<gpu::View> textures = sampled();

  for (int i = 0; i < desc_.samples; ++i) {
    std::vector<gpu::Pass>& passes = passes_.emplace_back();
    // The sky covers what no mesh does, and blended surfaces lie over both: one pass, so that the
    // picture is not stored and loaded in between.
    passes.push_back(
        {.label = "opaque",
         .colors = {{.view = gpu::whole(color_), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}},
         .depth = gpu::DepthTarget{.view = gpu::whole(depth_), .clear = 0.0f},
         .reads = textures,
         .record = [this, i](gpu::Encoder& encoder) {
           encoder.buffer("Frame", frames_.buffer, frames_.offset(static_cast<std::size_t>(i)),
                          frames_.size);
           encoder.buffer("Lights", uploaded_.lights());
           if (desc_.environment.stack) bind_environment(encoder);
           for (const auto& [draw, pipeline] : opaque_)
             draws_.record(encoder, pipeline, *draw);
           if (sky_) record_sky(encoder);
           for (const auto& [draw, pipeline] : blended_)
             draws_.record(encoder, pipeline, *draw);
         }});
    if (desc_.samples > 1) {
      gpu::ColorTarget average{.view = gpu::whole(average_)};
      if (i == 0) average.clear = std::array{0.0f, 0.0f, 0.0f, 0.0f};
      passes.push_back({.label = "accumulate",
                        .colors = {average},
                        .reads = {gpu::whole(color_)},
                        .record = [this](gpu::Encoder& encoder) {
                          encoder.use(accumulate_);
                          encoder.texture("sampleColor", gpu::whole(color_), nearest_);
                          encoder.draw(3);
                        }});
    }
  }
}

void Renderer::draw_sample(int i, std::map<std::string, double>* times) {
  if (!times) {
    device_.run(passes_[static_cast<std::size_t>(i)]);
    return;
  }
  std::vector<gpu::PassTime> measured;
  device_.run(passes_[static_cast<std::size_t>(i)], &measured);
  for (const gpu::PassTime& pass : measured)
    (*times)[pass.label] += pass.ms;
}

void Renderer::draw(std::map<std::string, double>* times) {
  for (int i = 0; i < desc_.samples; ++i)
    draw_sample(i, times);
}

image::Image Renderer::read() {
  const std::vector<std::byte> bytes = device_.read(desc_.samples > 1 ? average_ : color_, 0, 0);
  image::Image picture(desc_.width, desc_.height, 4);
  std::memcpy(picture.values.data(), bytes.data(), bytes.size());
  return picture;
}

std::vector<std::string> Renderer::pass_labels() const {
  std::vector<std::string> labels;
  for (const gpu::Pass& pass : passes_.front())
    labels.push_back(pass.label);
  return labels;
}

} // namespace gg::frame
