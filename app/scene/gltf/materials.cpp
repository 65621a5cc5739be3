#include "scene/gltf/materials.h"

#include "scene/gltf/fail.h"
#include "scene/gltf/values.h"

#include <algorithm>
#include <cmath>

namespace gg::scene::gltf {
namespace {

using tinygltf::ExtensionMap;
using tinygltf::Value;

float unit(double x) {
  return static_cast<float>(std::clamp(x, 0.0, 1.0));
}

// KHR_texture_transform: uv' = translation * rotation * scale * uv, turning counter-clockwise as
// seen with v downwards.
glm::mat3 uv_transform(const Value& extension) {
  const glm::vec2 offset = vector_or<2>(extension, "offset", glm::vec2(0.0f));
  const glm::vec2 scale = vector_or<2>(extension, "scale", glm::vec2(1.0f));
  const float angle = number_or(extension, "rotation", 0.0f);
  const float c = std::cos(angle), s = std::sin(angle);
  return {glm::vec3(scale.x * c, -scale.x * s, 0.0f), glm::vec3(scale.y * s, scale.y * c, 0.0f),
          glm::vec3(offset, 1.0f)};
}

void apply_transform(Slot& slot, const Value& extension) {
  slot.uv_set = integer_or(extension, "texCoord", slot.uv_set);
  slot.transform = uv_transform(extension);
}

// tinygltf has three classes for what the specification calls textureInfo.
template <class Info>
Slot slot_of(const Info& info) {
  Slot slot;
  slot.texture = info.index;
  slot.uv_set = info.texCoord;
  if (const auto found = info.extensions.find("KHR_texture_transform");
      found != info.extensions.end())
    apply_transform(slot, found->second);
  return slot;
}

Slot slot_or_none(const Value& extension, const char* key) {
  Slot slot;
  if (!extension.Has(key)) return slot;
  const Value& info = extension.Get(key);
  slot.texture = integer_or(info, "index", none);
  slot.uv_set = integer_or(info, "texCoord", 0);
  slot.scale = number_or(info, "scale", 1.0f);
  if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
    apply_transform(slot, info.Get("extensions").Get("KHR_texture_transform"));
  return slot;
}

void read_extensions(const ExtensionMap& extensions, Material& m) {
  const auto with = [&](const char* name, auto&& read) {
    if (const auto found = extensions.find(name); found != extensions.end()) read(found->second);
  };
  with("KHR_materials_unlit", [&](const Value&) { m.unlit = true; });
  with("KHR_materials_emissive_strength",
       [&](const Value& e) { m.emissive *= number_or(e, "emissiveStrength", 1.0f); });
  with("KHR_materials_ior", [&](const Value& e) { m.ior = number_or(e, "ior", m.ior); });
  with("KHR_materials_specular", [&](const Value& e) {
    m.specular = unit(number_or(e, "specularFactor", 1.0f));
    m.specular_color = vector_or<3>(e, "specularColorFactor", m.specular_color);
    m.specular_map = slot_or_none(e, "specularTexture");
    m.specular_color_map = slot_or_none(e, "specularColorTexture");
  });
  with("KHR_materials_transmission", [&](const Value& e) {
    m.transmission = unit(number_or(e, "transmissionFactor", 0.0f));
    m.transmission_map = slot_or_none(e, "transmissionTexture");
  });
  with("KHR_materials_volume", [&](const Value& e) {
    m.thickness = number_or(e, "thicknessFactor", 0.0f);
    m.thickness_map = slot_or_none(e, "thicknessTexture");
    m.attenuation_distance = number_or(e, "attenuationDistance", INFINITY);
    m.attenuation_color =
        glm::min(vector_or<3>(e, "attenuationColor", m.attenuation_color), glm::vec3(1.0f));
  });
  with("KHR_materials_dispersion",
       [&](const Value& e) { m.dispersion = number_or(e, "dispersion", 0.0f); });
  with("KHR_materials_anisotropy", [&](const Value& e) {
    m.anisotropy_strength = unit(number_or(e, "anisotropyStrength", 0.0f));
    m.anisotropy_rotation = number_or(e, "anisotropyRotation", 0.0f);
    m.anisotropy_map = slot_or_none(e, "anisotropyTexture");
  });
  with("KHR_materials_clearcoat", [&](const Value& e) {
    m.clearcoat = unit(number_or(e, "clearcoatFactor", 0.0f));
    m.clearcoat_map = slot_or_none(e, "clearcoatTexture");
    m.clearcoat_roughness = unit(number_or(e, "clearcoatRoughnessFactor", 0.0f));
    m.clearcoat_roughness_map = slot_or_none(e, "clearcoatRoughnessTexture");
    m.clearcoat_normal_map = slot_or_none(e, "clearcoatNormalTexture");
  });
  with("KHR_materials_iridescence", [&](const Value& e) {
    m.iridescence = unit(number_or(e, "iridescenceFactor", 0.0f));
    m.iridescence_map = slot_or_none(e, "iridescenceTexture");
    m.iridescence_ior = number_or(e, "iridescenceIor", m.iridescence_ior);
    m.iridescence_thickness = {number_or(e, "iridescenceThicknessMinimum", 100.0f),
                               number_or(e, "iridescenceThicknessMaximum", 400.0f)};
    m.iridescence_thickness_map = slot_or_none(e, "iridescenceThicknessTexture");
  });
  with("KHR_materials_diffuse_transmission", [&](const Value& e) {
    m.diffuse_transmission = unit(number_or(e, "diffuseTransmissionFactor", 0.0f));
    m.diffuse_transmission_map = slot_or_none(e, "diffuseTransmissionTexture");
    m.diffuse_transmission_color = glm::min(
        vector_or<3>(e, "diffuseTransmissionColorFactor", glm::vec3(1.0f)), glm::vec3(1.0f));
    m.diffuse_transmission_color_map = slot_or_none(e, "diffuseTransmissionColorTexture");
  });
}

} // namespace

Material read_material(const Document& document, int index) {
  const auto& source = document.model().materials[static_cast<std::size_t>(index)];
  const auto& pbr = source.pbrMetallicRoughness;
  Material m;
  m.name = source.name;
  m.base_color = glm::min(vector_of<4>(pbr.baseColorFactor), glm::vec4(1.0f));
  m.metallic = unit(pbr.metallicFactor);
  m.roughness = unit(pbr.roughnessFactor);
  if (!source.emissiveFactor.empty()) m.emissive = vector_of<3>(source.emissiveFactor);
  if (glm::any(glm::greaterThan(m.emissive, glm::vec3(1.0f))))
    note(document.name() + ": " + element("materials", index)
         + ".emissiveFactor is above 1, where KHR_materials_emissive_strength belongs; drawn as it "
           "says");
  m.alpha_mode = source.alphaMode == "MASK"    ? AlphaMode::mask
                 : source.alphaMode == "BLEND" ? AlphaMode::blend
                                               : AlphaMode::opaque;
  m.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  m.double_sided = source.doubleSided;
  m.base_color_map = slot_of(pbr.baseColorTexture);
  m.metallic_roughness_map = slot_of(pbr.metallicRoughnessTexture);
  m.normal_map = slot_of(source.normalTexture);
  m.normal_map.scale = static_cast<float>(source.normalTexture.scale);
  m.occlusion_map = slot_of(source.occlusionTexture);
  m.occlusion_map.scale = unit(source.occlusionTexture.strength);
  m.emissive_map = slot_of(source.emissiveTexture);
  read_extensions(source.extensions, m);
  return m;
}

Material default_material() {
  Material material;
  material.name = "default";
  return material;
}

} // namespace gg::scene::gltf
