#include "frame/uploaded_scene.h"

#include "frame/detail.h"
#include "frame/neighbour_blocks.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace gg::frame {
namespace {

using scene::Material;
using scene::Slot;

template <class T>
std::span<const std::byte> bytes(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

void set_rows(const Slot& slot, glm::vec4& row0, glm::vec4& row1) {
  const glm::mat3& t = slot.transform; // columns
  row0 = {t[0][0], t[1][0], t[2][0], 0.0f};
  row1 = {t[0][1], t[1][1], t[2][1], slot.scale};
}

// KHR_materials_volume: white light has attenuation_color after attenuation_distance, so the
// coefficient is -ln(color) / distance. Black would be infinite: the least normal float is used in its place, which
// no picture tells from 0.
glm::vec3 absorption_of(const Material& m) {
  if (!std::isfinite(m.attenuation_distance) || !(m.attenuation_distance > 0.0f))
    return glm::vec3(0.0f);
  const glm::vec3 color =
      glm::max(m.attenuation_color, glm::vec3(std::numeric_limits<float>::min()));
  return -glm::log(color) / m.attenuation_distance;
}

uniforms::MaterialData block_of(const Material& m) {
  uniforms::MaterialData block{};
  block.baseColor = m.base_color;
  block.emissive = glm::vec4(m.emissive, m.alpha_cutoff);
  block.surface = {m.metallic, m.roughness, scene::microfacet_alpha(m), m.ior};
  block.specular = glm::vec4(m.specular_color, m.specular);
  if (m.conductor) {
    block.conductorN = glm::vec4(m.conductor->n, 0.0f);
    block.conductorK = glm::vec4(m.conductor->k, 0.0f);
  }
  block.transmission = {m.transmission, m.back_alpha.value_or(-1.0f), m.dispersion, 0.0f};
  block.attenuation = glm::vec4(absorption_of(m), m.thickness);
  set_rows(m.base_color_map, block.baseColorRow0, block.baseColorRow1);
  set_rows(m.metallic_roughness_map, block.metallicRoughnessRow0, block.metallicRoughnessRow1);
  set_rows(m.normal_map, block.normalRow0, block.normalRow1);
  set_rows(m.occlusion_map, block.occlusionRow0, block.occlusionRow1);
  set_rows(m.emissive_map, block.emissiveRow0, block.emissiveRow1);
  set_rows(m.specular_map, block.specularRow0, block.specularRow1);
  set_rows(m.specular_color_map, block.specularColorRow0, block.specularColorRow1);
  set_rows(m.transmission_map, block.transmissionRow0, block.transmissionRow1);
  set_rows(m.thickness_map, block.thicknessRow0, block.thicknessRow1);
  block.clearcoat = {m.clearcoat, m.clearcoat_roughness, 0.0f, 0.0f};
  set_rows(m.clearcoat_map, block.clearcoatRow0, block.clearcoatRow1);
  set_rows(m.clearcoat_roughness_map, block.clearcoatRoughnessRow0, block.clearcoatRoughnessRow1);
  set_rows(m.clearcoat_normal_map, block.clearcoatNormalRow0, block.clearcoatNormalRow1);
  block.anisotropy = {m.anisotropy_strength, std::cos(m.anisotropy_rotation),
                      std::sin(m.anisotropy_rotation), 0.0f};
  set_rows(m.anisotropy_map, block.anisotropyRow0, block.anisotropyRow1);
  block.film = {m.iridescence, m.iridescence_ior, m.iridescence_thickness.x,
                m.iridescence_thickness.y};
  set_rows(m.iridescence_map, block.iridescenceRow0, block.iridescenceRow1);
  set_rows(m.iridescence_thickness_map, block.iridescenceThicknessRow0,
           block.iridescenceThicknessRow1);
  block.diffuseTransmission = glm::vec4(m.diffuse_transmission_color, m.diffuse_transmission);
  set_rows(m.diffuse_transmission_map, block.diffuseTransmissionRow0,
           block.diffuseTransmissionRow1);
  set_rows(m.diffuse_transmission_color_map, block.diffuseTransmissionColorRow0,
           block.diffuseTransmissionColorRow1);
  return block;
}

uniforms::LightData block_of(const scene::Light& light) {
  uniforms::LightData block{};
  block.position = glm::vec4(light.position, std::isfinite(light.range) && light.range > 0.0f
                                                 ? 1.0f / (light.range * light.range)
                                                 : 0.0f);
  block.direction = glm::vec4(light.direction, static_cast<float>(light.kind));
  block.intensity = glm::vec4(light.intensity, 0.0f);
  // KHR_lights_punctual, "Spot light": falloff = saturate(cos * scale + offset)². The extension
  // divides by at least 0.001 so that equal cones make a sharp edge instead of a division by 0.
  const float scale =
      1.0f / std::max(0.001f, std::cos(light.inner_cone) - std::cos(light.outer_cone));
  block.cone = {scale, -std::cos(light.outer_cone) * scale, 0.0f, 0.0f};
  return block;
}

uniforms::InstanceData block_of(const scene::Instance& instance, std::size_t index) {
  uniforms::InstanceData block{};
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

gpu::TextureRef upload_image(gpu::Device& device, const std::string& label,
                             const image::Image8& image, bool srgb, bool mipmaps) {
  const gpu::TextureRef texture = device.create(
      gpu::TextureDesc{.label = label,
                       .format = srgb ? gpu::Format::rgba8_srgb : gpu::Format::rgba8,
                       .width = image.width,
                       .height = image.height,
                       .levels = mipmaps ? needs::mip_levels(image.width, image.height) : 1,
                       .use = gpu::Use::sampled});
  device.upload(texture, 0, 0, std::as_bytes(std::span(image.rgba)));
  if (texture->desc.levels > 1) device.generate_mipmaps(texture);
  return texture;
}

} // namespace

void UploadedScene::set(const needs::Needs& needs) {
  needs_ = &needs;
  upload_geometry();
  upload_blocks();
  upload_textures();
}

void UploadedScene::upload_geometry() {
  const auto upload = [&](gpu::BufferRef& buffer, const char* name, scene::Index i,
                          std::span<const std::byte> values, gpu::Use use) {
    if (!buffer)
      buffer =
          device_.create(gpu::BufferDesc{name + std::to_string(i), values.size(), use}, values);
  };
  for (const scene::Index i : needs_->streams)
    upload(streams_[i], "stream ", i, bytes(needs_->stream(i).values), gpu::Use::vertices);
  for (const scene::Index i : needs_->index_lists)
    upload(indices_[i], "indices ", i, bytes(needs_->scene->indices[static_cast<std::size_t>(i)]),
           gpu::Use::indices);
  coarsely_drawn_.clear();
  if (!coarse_) return;
  for (const needs::Draw& draw : needs_->draws.all) {
    const scene::Index i = draw.primitive->indices;
    const scene::CoarseList* list =
        coarsest(*coarse_, draw, *needs_->draws.instances[draw.instance_index], needs_->view);
    if (!list) continue;
    upload(coarse_indices_[list], "coarse indices ", i, bytes(list->indices), gpu::Use::indices);
    coarsely_drawn_.emplace(&draw, list);
  }
}

UploadedScene::Triangles UploadedScene::triangles(const needs::Draw& draw) const {
  const auto coarse = coarsely_drawn_.find(&draw);
  if (coarse != coarsely_drawn_.end())
    return {coarse_indices_.at(coarse->second), coarse->second->indices.size()};
  return {indices_.at(draw.primitive->indices), draw.index_count};
}

void UploadedScene::upload_blocks() {
  std::vector<uniforms::MaterialData> materials;
  for (const Material* m : needs_->draws.materials) {
    materials.push_back(block_of(*m));
    materials.back().transmission.w =
        static_cast<float>(needs_->draws.bodies[materials.size() - 1]);
  }
  update_uniforms(device_, materials_, "materials", materials);
  std::vector<uniforms::InstanceData> instances;
  for (const scene::Instance* i : needs_->draws.instances)
    instances.push_back(block_of(*i, instances.size()));
  update_uniforms(device_, instances_, "instances", instances);

  neighbour_blocks_.clear();
  for (const needs::Draw& draw : needs_->draws.all)
    if (!draw.neighbours.empty()) neighbour_blocks_.emplace(&draw, neighbour_blocks_.size());
  if (!neighbour_blocks_.empty())
    update_uniforms(device_, neighbours_, "neighbours", neighbour_blocks(*needs_, image_means_));

  std::vector<uniforms::LightData> lights;
  for (const scene::Light& light : needs_->scene->lights) {
    const std::size_t i = lights.size();
    lights.push_back(block_of(light));
    if (needs_->shadows.views.empty()) continue;
    const needs::LightViews& views = needs_->shadows.of_light[i];
    lights.back().cone.z = static_cast<float>(views.first);
    lights.back().cone.w = views.nothing_casts ? -1.0f : static_cast<float>(views.count);
  }
  if (lights.empty()) lights.emplace_back();
  if (lights_) // as many as before, which may have been moved
    device_.upload(lights_, 0, bytes(lights));
  else
    lights_ = device_.create(gpu::BufferDesc{"lights", bytes(lights).size(), gpu::Use::storage},
                             bytes(lights));
}

void UploadedScene::upload_textures() {
  for (const needs::Image& image : needs_->images) {
    gpu::TextureRef& texture = images_[{image.image, image.srgb}];
    if (!texture || (image.mipmaps && texture->desc.levels == 1))
      texture = upload_image(device_, "image " + std::to_string(image.image),
                             *needs_->scene->images[static_cast<std::size_t>(image.image)],
                             image.srgb, image.mipmaps);
  }
  for (const needs::Draw* draw : needs_->read())
    for (const needs::Map& map : draw->maps) {
      const auto [at, is_new] = samplers_.try_emplace(map.texture);
      if (is_new)
        at->second = device_.create(
            sampler_of(needs_->scene->textures[static_cast<std::size_t>(map.texture)].sampler));
    }
}

UploadedTexture UploadedScene::texture(const needs::Map& map) const {
  const scene::Index image = needs_->scene->textures[static_cast<std::size_t>(map.texture)].image;
  return {gpu::whole(images_.at({image, map.srgb})), samplers_.at(map.texture)};
}

std::vector<gpu::View> UploadedScene::sampled() const {
  std::vector<gpu::View> views;
  for (const auto& [of, texture] : images_)
    views.push_back(gpu::whole(texture));
  return views;
}

} // namespace gg::frame
