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

// Glass behind glass behind glass...: each layer takes a pyramid of its own. Past so many, surfaces
// share the last one: they hide each other but do not show each other.
constexpr std::size_t most_layers = 8;

// Front and back faces that the search for a ray's exit sees behind each other.
constexpr int interior_pairs = 2;

// Whether a thing's reflection shows what stands about it: metals, and what is glossy. A rough
// dielectric reflects 4 % of a blur of half the world: its error without is below that.
bool reflects_company(const Draw& draw) {
  const scene::Material& m = *draw.material;
  if (m.unlit) return false;
  return m.conductor || m.metallic > 0.0f || scene::microfacet_alpha(m) < 0.25f;
}

// The search for the exit follows rays in layers of the solid's faces. What bends nothing needs to
// know how thick it is if it absorbs; peers' method takes the material's word for it.
bool has_interior(const Draw& draw) {
  const scene::Material& m = *draw.material;
  return draw.role == Role::refractive && m.thickness > 0.0f;
}

} // namespace

Renderer::Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc)
    : device_(device), desc_(desc), uploaded_(device, scene), tables_(wanted_tables()),
      draws_(device, uploaded_, tables_, features(), desc.camera),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})) {
  make_targets();
  make_layers();
  make_frame_blocks();
  make_passes();
}

Renderer::~Renderer() = default;

tables::DeviceTables Renderer::wanted_tables() const {
  std::vector<tables::Model> wanted, transmitting;
  for (const scene::Material& material : uploaded_.scene().materials) {
    if (material.unlit) continue;
    if (desc_.environment.stack) wanted.push_back(model_of(material, desc_.correlated_smith));
    if (is_refractive(material) && material.ior != 1.0f && taps_of(desc_.method) > 0)
      transmitting.push_back(model_of(material, desc_.correlated_smith));
  }
  tables::DeviceTables tables = tables::upload(device_, wanted);
  // What is composed of two interfaces needs two taps of each at most (refraction/composition_fetch.glsl).
  tables::upload_interfaces(device_, tables, transmitting, std::min(taps_of(desc_.method), 2));
  return tables;
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
  depth_ = target("scene depth", depth_format, gpu::Use::sampled);
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
    f.picture = {desc_.width, desc_.height,
                 0.5 * clip_from_view(camera, aspect)[1][1] * desc_.height,
                 backdrop_ ? backdrop_->last_level() : 0};
    f.boundsLow = vec4(uploaded_.scene().bounds.low, 0.0f);
    f.boundsHigh = vec4(uploaded_.scene().bounds.high, 0.0f);
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

Renderer::Recorded Renderer::recorded(const DrawPass& pass, const LayerDraw& draw) {
  const gpu::Cull cull = draw.faces == Faces::front  ? gpu::Cull::back
                         : draw.faces == Faces::back ? gpu::Cull::front
                         : draw.draw->both_sides     ? gpu::Cull::none
                                                     : gpu::Cull::back;
  return {draw.draw, draws_.pipeline(pass, *draw.draw), cull};
}

void Renderer::make_layers() {
  const bool company =
      desc_.environment.stack && draws_.all().size() > 1 && desc_.method != Method::standard;
  const DrawPass opaque{.label = "opaque", .fragment = "opaque.frag", .colors = {color_format}};
  const DrawPass blended{.label = "blended",
                         .fragment = "opaque.frag",
                         .colors = {color_format},
                         .depth_write = false,
                         .blend = gpu::Blend::over};
  const DrawPass refractive{
      .label = "refractive",
      .fragment = "refractive.frag",
      .colors = {color_format},
      .blend = gpu::Blend::over,
      .constants = {gpu::constant(40, interior_pairs), gpu::constant(41, company)}};
  // Once more over the opaque picture, which shows what there is to reflect.
  const DrawPass reflective{.label = "reflective",
                            .fragment = "opaque.frag",
                            .colors = {color_format},
                            .depth_write = false,
                            .constants = {gpu::constant(41, true)}};
  for (const Draw* draw : draws_.of(Role::opaque)) {
    opaque_.push_back(recorded(opaque, {draw, Faces::as_material}));
    if (company && reflects_company(*draw))
      reflective_.push_back(recorded(reflective, {draw, Faces::as_material}));
  }
  if (!reflective_.empty()) backdrop_.emplace(device_, desc_.width, desc_.height);

  const double aspect = static_cast<double>(desc_.width) / desc_.height;
  const glm::dmat4 clip_from_world =
      clip_from_view(desc_.camera, aspect) * view_from_world(desc_.camera);
  for (const Layer& layer : layers_of(draws_.all(), clip_from_world, most_layers)) {
    if (!layer.refractive.empty() && !backdrop_)
      backdrop_.emplace(device_, desc_.width, desc_.height);
    // What lies over opaque surfaces alone needs no pass of its own.
    if (layers_.empty() && layer.refractive.empty()) {
      for (const LayerDraw& draw : layer.blended)
        over_opaque_.push_back(recorded(blended, draw));
      continue;
    }
    GlassLayer& made = layers_.emplace_back();
    made.refracts = !layer.refractive.empty();
    made.foreground = layer.foreground;
    for (const LayerDraw& draw : layer.refractive)
      if (has_interior(*draw.draw)) made.solids.push_back(draw.draw);
    if (!made.solids.empty() && !interior_)
      interior_.emplace(device_, desc_.width, desc_.height, interior_pairs);
    for (const LayerDraw& draw : layer.refractive)
      made.draws.push_back(recorded(refractive, draw));
    for (const LayerDraw& draw : layer.blended)
      made.draws.push_back(recorded(blended, draw));
  }
}

void Renderer::begin(gpu::Encoder& encoder, int sample) const {
  encoder.buffer("Frame", frames_.buffer, frames_.offset(static_cast<std::size_t>(sample)),
                 frames_.size);
  encoder.buffer("Lights", uploaded_.lights());
  if (desc_.environment.stack) bind_environment(encoder);
}

gpu::Pass Renderer::opaque_pass(int sample) const {
  return {.label = "opaque",
          .colors = {{.view = gpu::whole(color_), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}},
          .depth = gpu::DepthTarget{.view = gpu::whole(depth_), .clear = 0.0f},
          .reads = sampled(),
          .record = [this, sample](gpu::Encoder& encoder) {
            begin(encoder, sample);
            for (const auto& [draw, pipeline, cull] : opaque_)
              draws_.record(encoder, pipeline, *draw, cull);
            if (sky_) record_sky(encoder);
            for (const auto& [draw, pipeline, cull] : over_opaque_)
              draws_.record(encoder, pipeline, *draw, cull);
          }};
}

gpu::Pass Renderer::reflective_pass(int sample) const {
  gpu::Pass pass{.label = "reflective",
                 .colors = {{.view = gpu::whole(color_)}},
                 .depth = gpu::DepthTarget{.view = gpu::whole(depth_)},
                 .reads = sampled(),
                 .record = [this, sample](gpu::Encoder& encoder) {
                   begin(encoder, sample);
                   backdrop_->bind(encoder);
                   for (const auto& [draw, pipeline, cull] : reflective_)
                     draws_.record(encoder, pipeline, *draw, cull);
                 }};
  for (const gpu::View& view : backdrop_->sampled())
    pass.reads.push_back(view);
  return pass;
}

gpu::Pass Renderer::layer_pass(int sample, std::size_t i) const {
  const GlassLayer& layer = layers_[i];
  gpu::Pass pass{.label = layer.refracts ? "refractive" : "blended",
                 .colors = {{.view = gpu::whole(color_)}},
                 .depth = gpu::DepthTarget{.view = gpu::whole(depth_)},
                 .reads = sampled()};
  if (layer.refracts)
    for (const gpu::View& view : backdrop_->sampled())
      pass.reads.push_back(view);
  if (!layer.solids.empty()) pass.reads.push_back(interior_->sampled());
  pass.record = [this, sample, i](gpu::Encoder& encoder) {
    begin(encoder, sample);
    if (layers_[i].refracts) {
      backdrop_->bind(encoder);
    }
    if (!layers_[i].solids.empty()) interior_->bind(encoder);
    for (const auto& [draw, pipeline, cull] : layers_[i].draws)
      draws_.record(encoder, pipeline, *draw, cull);
  };
  return pass;
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
  for (int i = 0; i < desc_.samples; ++i) {
    std::vector<gpu::Pass>& passes = passes_.emplace_back();
    passes.push_back(opaque_pass(i));
    const auto bind = [this, i](gpu::Encoder& encoder) { begin(encoder, i); };
    if (!reflective_.empty()) {
      backdrop_->add_passes(passes, color_, depth_, true, draws_, {}, bind);
      passes.push_back(reflective_pass(i));
    }
    for (std::size_t l = 0; l < layers_.size(); ++l) {
      if (layers_[l].refracts)
        backdrop_->add_passes(passes, color_, depth_, l == 0 && reflective_.empty(), draws_,
                              layers_[l].foreground, bind);
      if (!layers_[l].solids.empty())
        interior_->add_passes(passes, draws_, layers_[l].solids, interior_pairs, bind);
      passes.push_back(layer_pass(i, l));
    }
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
