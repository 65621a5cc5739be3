#include "frame/uploaded_scene.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace gg::frame {
namespace {

using scene::Index;
using scene::Material;
using scene::Slot;

template <class T>
std::span<const std::byte> bytes(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

void set_rows(const Slot& slot, vec4& row0, vec4& row1) {
  const glm::mat3& t = slot.transform; // columns
  row0 = {t[0][0], t[1][0], t[2][0], 0.0f};
  row1 = {t[0][1], t[1][1], t[2][1], slot.scale};
}

// KHR_materials_volume: white light has attenuation_color after attenuation_distance, so the
// coefficient is -ln(color) / distance. Black would be infinite: the least normal float stands for
// it, which no picture tells from 0.
glm::vec3 absorption_of(const Material& m) {
  if (!std::isfinite(m.attenuation_distance) || !(m.attenuation_distance > 0.0f))
    return glm::vec3(0.0f);
  const glm::vec3 color =
      glm::max(m.attenuation_color, glm::vec3(std::numeric_limits<float>::min()));
  return -glm::log(color) / m.attenuation_distance;
}

MaterialData block_of(const Material& m) {
  MaterialData block{};
  block.baseColor = m.base_color;
  block.emissive = vec4(m.emissive, m.alpha_cutoff);
  block.surface = {m.metallic, m.roughness, scene::microfacet_alpha(m), m.ior};
  block.specular = vec4(m.specular_color, m.specular);
  if (m.conductor) {
    block.conductorN = vec4(m.conductor->n, 0.0f);
    block.conductorK = vec4(m.conductor->k, 0.0f);
  }
  block.transmission = {m.transmission, m.back_alpha.value_or(-1.0f), m.dispersion, 0.0f};
  block.attenuation = vec4(absorption_of(m), m.thickness);
  set_rows(m.base_color_map, block.baseColorRow0, block.baseColorRow1);
  set_rows(m.metallic_roughness_map, block.metallicRoughnessRow0, block.metallicRoughnessRow1);
  set_rows(m.normal_map, block.normalRow0, block.normalRow1);
  set_rows(m.occlusion_map, block.occlusionRow0, block.occlusionRow1);
  set_rows(m.emissive_map, block.emissiveRow0, block.emissiveRow1);
  set_rows(m.specular_map, block.specularRow0, block.specularRow1);
  set_rows(m.specular_color_map, block.specularColorRow0, block.specularColorRow1);
  set_rows(m.transmission_map, block.transmissionRow0, block.transmissionRow1);
  set_rows(m.thickness_map, block.thicknessRow0, block.thicknessRow1);
  return block;
}

LightData block_of(const scene::Light& light) {
  LightData block{};
  block.position = vec4(light.position, std::isfinite(light.range) && light.range > 0.0f
                                            ? 1.0f / (light.range * light.range)
                                            : 0.0f);
  block.direction = vec4(light.direction, static_cast<float>(light.kind));
  block.intensity = vec4(light.intensity, 0.0f);
  // KHR_lights_punctual, "Spot light": falloff = saturate(cos * scale + offset)². The extension
  // divides by at least 0.001 so that equal cones make a sharp edge instead of a division by 0.
  const float scale =
      1.0f / std::max(0.001f, std::cos(light.inner_cone) - std::cos(light.outer_cone));
  block.cone = {scale, -std::cos(light.outer_cone) * scale, 0.0f, 0.0f};
  return block;
}

InstanceData block_of(const scene::Instance& instance, std::size_t index) {
  InstanceData block{};
  block.worldFromMesh = instance.world;
  // A singular transform (scale 0 along an axis) has no inverse; such a mesh is flat and its
  // normals are not lit, but the numbers must stay finite.
  const glm::dmat3 m(instance.world);
  glm::dmat3 normal = std::abs(glm::determinant(m)) > 0.0 ? glm::transpose(glm::inverse(m)) : m;
  // Only the direction of a normal counts: a unit-sized matrix keeps float32 in range for
  // millimetres and kilometres.
  double largest = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      largest = std::max(largest, std::abs(normal[c][r]));
  if (largest > 0.0) normal /= largest;
  block.normalFromMesh = glm::mat4(glm::mat3(normal));
  // A mirrored tangent frame has its bitangent on the other side of n x t.
  block.normalFromMesh[3][0] = static_cast<float>(index);
  block.normalFromMesh[3][3] = instance.mirrored ? -1.0f : 1.0f;
  return block;
}

gpu::SamplerDesc sampler_of(const scene::Sampler& sampler) {
  const auto wrap = [](scene::Wrap w) {
    return w == scene::Wrap::repeat  ? gpu::Wrap::repeat
           : w == scene::Wrap::clamp ? gpu::Wrap::clamp
                                     : gpu::Wrap::mirrored_repeat;
  };
  const auto filter = [](scene::Filter f) {
    return f == scene::Filter::linear ? gpu::Filter::linear : gpu::Filter::nearest;
  };
  return {.magnify = filter(sampler.magnify),
          .minify = filter(sampler.minify),
          .between_levels = filter(sampler.between_levels),
          .u = wrap(sampler.wrap_s),
          .v = wrap(sampler.wrap_t),
          .max_level = sampler.mipmaps ? 1000.0f : 0.0f};
}

int level_count(int width, int height) {
  return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

gpu::TextureRef upload_image(gpu::Device& device, const std::string& label,
                             const image::Image8& image, bool srgb, bool mipmaps) {
  const gpu::TextureRef texture =
      device.create(gpu::TextureDesc{.label = label,
                                     .format = srgb ? gpu::Format::rgba8_srgb : gpu::Format::rgba8,
                                     .width = image.width,
                                     .height = image.height,
                                     .levels = mipmaps ? level_count(image.width, image.height) : 1,
                                     .use = gpu::Use::sampled});
  device.upload(texture, 0, 0, std::as_bytes(std::span(image.rgba)));
  if (texture->desc.levels > 1) device.generate_mipmaps(texture);
  return texture;
}

} // namespace

UploadedScene::UploadedScene(gpu::Device& device, const scene::Scene& scene) : scene_(scene) {
  for (std::size_t i = 0; i < scene.streams.size(); ++i)
    streams_.push_back(
        device.create(gpu::BufferDesc{"stream " + std::to_string(i),
                                      bytes(scene.streams[i].values).size(), gpu::Use::vertices},
                      bytes(scene.streams[i].values)));
  for (std::size_t i = 0; i < scene.indices.size(); ++i)
    indices_.push_back(
        device.create(gpu::BufferDesc{"indices " + std::to_string(i),
                                      bytes(scene.indices[i]).size(), gpu::Use::indices},
                      bytes(scene.indices[i])));

  std::vector<MaterialData> materials;
  for (const Material& m : scene.materials) {
    materials.push_back(block_of(m));
    materials.back().transmission.w = static_cast<float>(materials.size() - 1);
  }
  materials_ = upload_uniforms(device, "materials", materials);
  std::vector<InstanceData> instances;
  for (const scene::Instance& i : scene.instances)
    instances.push_back(block_of(i, instances.size()));
  instances_ = upload_uniforms(device, "instances", instances);

  std::vector<LightData> lights;
  for (const scene::Light& light : scene.lights)
    lights.push_back(block_of(light));
  if (lights.empty()) lights.emplace_back();
  lights_ = device.create(gpu::BufferDesc{"lights", bytes(lights).size(), gpu::Use::storage},
                          bytes(lights));

  upload_textures(device);
}

void UploadedScene::upload_textures(gpu::Device& device) {
  const image::Image8 one{.width = 1, .height = 1, .rgba = {255, 255, 255, 255}};
  white_ = {gpu::whole(upload_image(device, "white", one, false, false)),
            device.create(gpu::SamplerDesc{})};

  for (const scene::Texture& texture : scene_.textures)
    samplers_.push_back(device.create(sampler_of(texture.sampler)));
  images_.resize(scene_.images.size());
  const auto need = [&](const Slot& slot, bool srgb) {
    if (!slot) return;
    const Index i = scene_.textures[static_cast<std::size_t>(slot.texture)].image;
    if (i == scene::none || !scene_.images[static_cast<std::size_t>(i)]) return;
    Image& image = images_[static_cast<std::size_t>(i)];
    gpu::TextureRef& texture = srgb ? image.srgb : image.linear;
    if (!texture)
      texture = upload_image(device, "image " + std::to_string(i),
                             *scene_.images[static_cast<std::size_t>(i)], srgb, true);
  };
  for (const Material& m : scene_.materials) {
    need(m.base_color_map, true);
    need(m.emissive_map, true);
    need(m.specular_color_map, true);
    need(m.metallic_roughness_map, false);
    need(m.normal_map, false);
    need(m.occlusion_map, false);
    need(m.specular_map, false);
    need(m.transmission_map, false);
    need(m.thickness_map, false);
  }
}

UploadedTexture UploadedScene::texture(Index texture, bool srgb) const {
  const Index i = scene_.textures[static_cast<std::size_t>(texture)].image;
  if (i == scene::none) return white_;
  const Image& image = images_[static_cast<std::size_t>(i)];
  const gpu::TextureRef& found = srgb ? image.srgb : image.linear;
  if (!found) return white_;
  return {gpu::whole(found), samplers_[static_cast<std::size_t>(texture)]};
}

} // namespace gg::frame
