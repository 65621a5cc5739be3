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

// Attribute locations of stages/opaque.vert; each has a vertex binding of its own, as glTF's
// streams are separate.
constexpr int position_location = 0, normal_location = 1, tangent_location = 2, color_location = 3,
              uv_location = 4;

struct MapName {
  const char* name;
  scene::Slot scene::Material::*slot;
  Feature feature;
  bool srgb;
};
constexpr MapName maps[] = {
    {"baseColorMap", &scene::Material::base_color_map, Feature::base_color_map, true},
    {"metallicRoughnessMap", &scene::Material::metallic_roughness_map,
     Feature::metallic_roughness_map, false},
    {"normalMap", &scene::Material::normal_map, Feature::normal_map, false},
    {"occlusionMap", &scene::Material::occlusion_map, Feature::occlusion_map, false},
    {"emissiveMap", &scene::Material::emissive_map, Feature::emissive_map, true},
    {"specularMap", &scene::Material::specular_map, Feature::specular_map, false},
    {"specularColorMap", &scene::Material::specular_color_map, Feature::specular_color_map, true},
};

int value_of(const FeatureKey& key, Feature feature) {
  return key[static_cast<std::size_t>(feature)];
}

// The inputs of stages/opaque.vert that are left when it is specialised, each from a vertex buffer
// of its own, as glTF's streams are separate.
struct Input {
  int location, components;
};
std::vector<Input> attributes_of(const FeatureKey& key) {
  std::vector<Input> inputs{{position_location, 3}, {normal_location, 3}};
  if (value_of(key, Feature::normal_map) > 0) inputs.push_back({tangent_location, 4});
  if (value_of(key, Feature::vertex_color) > 0) inputs.push_back({color_location, 4});
  for (int k = 0; k < value_of(key, Feature::uv_sets); ++k)
    inputs.push_back({uv_location + k, 2});
  return inputs;
}

// The streams that feed them, in the same order.
std::vector<scene::Index> streams_of(const FeatureKey& key, const scene::Primitive& p,
                                     const std::vector<int>& uv_sets) {
  std::vector<scene::Index> streams{p.positions, p.normals};
  if (value_of(key, Feature::normal_map) > 0) streams.push_back(p.tangents);
  if (value_of(key, Feature::vertex_color) > 0) streams.push_back(p.colors);
  for (const int set : uv_sets)
    streams.push_back(p.uvs[static_cast<std::size_t>(set)]);
  return streams;
}

// The tables that stand for a material's lobe.
tables::Model model_of(const scene::Material& material, bool correlated_smith) {
  switch (material.distribution) {
  case scene::Distribution::ggx:
    return {tables::Distribution::ggx,
            correlated_smith ? tables::Smith::correlated : tables::Smith::separable};
  case scene::Distribution::beckmann:
    return {tables::Distribution::beckmann, tables::Smith::separable};
  case scene::Distribution::phong:
    return {tables::Distribution::phong, tables::Smith::separable};
  }
  return {};
}

} // namespace

struct Renderer::Draw {
  const scene::Primitive* primitive;
  const scene::Material* material;
  std::size_t material_index, instance_index;
  FeatureKey key;
  gpu::PipelineRef pipeline;
  double distance;                   // from the eye, of the centre of its bounds: for order
  std::vector<scene::Index> streams; // one per vertex binding
  struct Map {
    const char* name;
    UploadedTexture texture;
  };
  std::vector<Map> maps;
  std::uint32_t index_count;
  bool mirrored, both_sides;
};

Renderer::Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc)
    : device_(device), desc_(desc), uploaded_(device, scene),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})) {
  upload_tables();
  make_targets();
  make_frame_blocks();
  make_draws();
  make_passes();
}

Renderer::~Renderer() = default;

void Renderer::upload_tables() {
  if (!desc_.environment.stack) return;
  std::vector<tables::Model> wanted;
  for (const scene::Material& material : uploaded_.scene().materials)
    if (!material.unlit) wanted.push_back(model_of(material, desc_.correlated_smith));
  tables_ = tables::upload(device_, wanted);
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

void Renderer::make_draws() {
  const scene::Scene& scene = uploaded_.scene();
  FrameFeatures frame{.method = desc_.method,
                      .correlated_smith = desc_.correlated_smith,
                      .multiple_scattering = desc_.multiple_scattering,
                      .environment = desc_.environment.stack != nullptr,
                      .lights = !scene.lights.empty()};
  const glm::vec3 eye(desc_.camera.world[3]);
  const glm::vec3 forward = -glm::normalize(glm::vec3(desc_.camera.world[2]));
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Instance& instance = scene.instances[i];
    for (const scene::Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      Draw draw{};
      draw.primitive = &primitive;
      draw.material_index = static_cast<std::size_t>(primitive.material);
      draw.material = &scene.materials[draw.material_index];
      draw.instance_index = i;
      draw.key = features_of(*draw.material, primitive, frame);
      const bool blended = draw.material->alpha_mode == scene::AlphaMode::blend;
      draw.pipeline = pipeline(draw.key, blended);
      const glm::vec3 centre(instance.world * glm::vec4(primitive.bounds.centre(), 1.0f));
      draw.distance = glm::dot(centre - eye, forward);
      draw.streams = streams_of(draw.key, primitive, uv_sets_of(*draw.material, primitive));
      for (const MapName& map : maps)
        if (value_of(draw.key, map.feature) > 0)
          draw.maps.push_back(
              {map.name, uploaded_.texture((draw.material->*map.slot).texture, map.srgb)});
      draw.index_count = static_cast<std::uint32_t>(
          scene.indices[static_cast<std::size_t>(primitive.indices)].size());
      draw.mirrored = instance.mirrored;
      draw.both_sides = draw.material->double_sided;
      triangles_ += draw.index_count / 3;
      (blended ? blended_ : opaque_).push_back(std::move(draw));
    }
  }
  // Opaque near to far, so that the depth test spares hidden shading; blended far to near, so that
  // "over" is right.
  std::ranges::stable_sort(opaque_, std::less{}, &Draw::distance);
  std::ranges::stable_sort(blended_, std::greater{}, &Draw::distance);
}

gpu::PipelineRef Renderer::pipeline(const FeatureKey& key, bool blended) {
  gpu::PipelineRef& found = pipelines_[{key, blended}];
  if (found) return found;
  gpu::PipelineDesc desc{.label = blended ? "blended" : "opaque",
                         .vertex = "opaque.vert",
                         .fragment = "opaque.frag",
                         .constants = constants_of(key),
                         .colors = {color_format},
                         .depth = depth_format,
                         .depth_write = !blended,
                         .blend = blended ? gpu::Blend::over : gpu::Blend::none};
  for (const auto& [location, components] : attributes_of(key)) {
    desc.attributes.push_back({.location = location,
                               .components = components,
                               .binding = static_cast<int>(desc.bindings.size())});
    desc.bindings.push_back({.stride = static_cast<std::uint32_t>(components) * 4u});
  }
  found = device_.create(desc);
  return found;
}

void Renderer::record(gpu::Encoder& encoder, const Draw& draw) const {
  const scene::Primitive& p = *draw.primitive;
  const UniformArray& materials = uploaded_.materials();
  const UniformArray& instances = uploaded_.instances();
  encoder.use(draw.pipeline);
  encoder.buffer("Instance", instances.buffer, instances.offset(draw.instance_index),
                 instances.size);
  encoder.buffer("Material", materials.buffer, materials.offset(draw.material_index),
                 materials.size);
  for (std::size_t k = 0; k < draw.streams.size(); ++k)
    encoder.vertices(static_cast<int>(k), uploaded_.stream(draw.streams[k]));
  if (desc_.environment.stack && !draw.material->unlit) {
    const tables::ModelTables& tables =
        tables_.of(model_of(*draw.material, desc_.correlated_smith));
    encoder.texture("energyTable", gpu::whole(tables.energy), tables_.sampler);
    encoder.texture("lobeTable", gpu::whole(tables.lobe), tables_.sampler);
  }
  for (const Draw::Map& map : draw.maps)
    encoder.texture(map.name, map.texture.view, map.texture.sampler);
  encoder.cull(draw.both_sides ? gpu::Cull::none : gpu::Cull::back);
  encoder.front_is_clockwise(draw.mirrored);
  encoder.indices(uploaded_.indices(p.indices));
  encoder.draw_indexed(draw.index_count);
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
  std::vector<gpu::View> views;
  for (const auto* draws : {&opaque_, &blended_})
    for (const Draw& draw : *draws)
      for (const Draw::Map& map : draw.maps)
        views.push_back(map.texture.view);
  if (const environment::Stack* stack = desc_.environment.stack)
    for (const gpu::TextureRef& cube : {stack->even, stack->odd, stack->irradiance})
      views.push_back(gpu::whole(cube));
  for (const tables::ModelTables& model : tables_.of_model)
    for (const gpu::TextureRef& table : {model.energy, model.lobe})
      if (table) views.push_back(gpu::whole(table));
  return views;
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
           for (const Draw& draw : opaque_)
             record(encoder, draw);
           if (sky_) record_sky(encoder);
           for (const Draw& draw : blended_)
             record(encoder, draw);
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
