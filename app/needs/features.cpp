#include "needs/features.h"

#include "core/error.h"
#include "glsl/f32.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gg::needs {
namespace {

using scene::Material;
using scene::Primitive;
using scene::Slot;

bool has_uv_set(const Slot& slot, const Primitive& primitive) {
  return slot && slot.uv_set < static_cast<int>(primitive.uvs.size())
         && primitive.uvs[static_cast<std::size_t>(slot.uv_set)] != scene::none;
}

bool has_image(const scene::Scene& scene, const Slot& slot) {
  const scene::Index image = scene.textures[static_cast<std::size_t>(slot.texture)].image;
  return image != scene::none && scene.images[static_cast<std::size_t>(image)];
}

Shading shading_of(const Material& m, const Primitive& primitive) {
  if (m.unlit) return Shading::unlit;
  if (m.conductor) return Shading::conductor;
  if (m.metallic <= 0.0f) return Shading::dielectric;
  // A map can only lower the factor, so it makes a mixture of any metal.
  if (has_uv_set(m.metallic_roughness_map, primitive) || m.metallic < 1.0f) return Shading::mixed;
  return Shading::metal;
}

Transmission transmission_of(const Material& m) {
  if (!is_refractive(m)) return Transmission::none;
  return m.thickness > 0.0f ? Transmission::solid : Transmission::thin;
}

bool absorbs(const Material& m) {
  return m.thickness > 0.0f && std::isfinite(m.attenuation_distance)
         && m.attenuation_color != glm::vec3(1.0f);
}

// Neither diffuse nor metal: glass alone.
bool is_all_glass(const Material& m) {
  return is_refractive(m) && m.transmission == 1.0f && !m.transmission_map && m.metallic <= 0.0f;
}

// Glass that neither bends nor reflects light has no face that a layer would lie on.
bool has_face(const Material& m) {
  return !(is_all_glass(m) && m.ior == 1.0f);
}

// Over opaque surfaces, and over the outside of glass.
bool has_coat(const Material& m, const FrameFeatures& frame) {
  return m.clearcoat > 0.0f && has_face(m) && !has(frame.without, Feature::clearcoat);
}

// A film on the substrate: in what it reflects, and in what glass lets in.
bool has_film(const Material& m, const FrameFeatures& frame) {
  if (has(frame.without, Feature::iridescence)) return false;
  const float thickest = m.iridescence_thickness_map
                             ? std::max(m.iridescence_thickness.x, m.iridescence_thickness.y)
                             : m.iridescence_thickness.y;
  return m.iridescence > 0.0f && thickest > 0.0f && has_face(m);
}

// The base under a dielectric, where light does not pass it by refraction.
bool passes_diffuse(const Material& m) {
  return m.diffuse_transmission > 0.0f && !is_refractive(m) && !m.conductor && !m.unlit
         && (m.metallic < 1.0f || m.metallic_roughness_map);
}

// Alpha is 0 everywhere: a map scales roughness, so that one of 0 stays.
bool is_smooth(const Material& m, int brushed, bool coated) {
  if (brushed > 0) return false;
  if (coated && m.clearcoat_roughness > 0.0f) return false; // tables are read
  return scene::microfacet_alpha(m) == 0.0f && m.back_alpha.value_or(0.0f) == 0.0f;
}

// Whether the material can look different with this map than without: a map only scales its factors.
bool matters(const MapKind& map, const Material& m, Shading shading, const FrameFeatures& frame) {
  const bool dielectric = shading == Shading::dielectric || shading == Shading::mixed;
  switch (map.feature) {
  case Feature::base_color_map:
    return shading != Shading::conductor || m.alpha_mode != scene::AlphaMode::opaque;
  case Feature::metallic_roughness_map:
    return m.metallic > 0.0f || (m.roughness > 0.0f && !m.exact_alpha);
  case Feature::occlusion_map:
    return frame.environment && m.occlusion_map.scale != 0.0f;
  case Feature::emissive_map:
    return m.emissive != glm::vec3(0.0f);
  case Feature::specular_map:
  case Feature::specular_color_map:
    return dielectric && m.specular > 0.0f;
  case Feature::transmission_map:
    return is_refractive(m);
  case Feature::thickness_map:
    return transmission_of(m) == Transmission::solid;
  case Feature::clearcoat_map:
  case Feature::clearcoat_normal_map:
    return has_coat(m, frame);
  case Feature::clearcoat_roughness_map:
    return has_coat(m, frame) && m.clearcoat_roughness > 0.0f;
  case Feature::iridescence_map:
  case Feature::iridescence_thickness_map:
    return has_film(m, frame);
  case Feature::diffuse_transmission_map:
  case Feature::diffuse_transmission_color_map:
    return passes_diffuse(m);
  default:
    return true;
  }
}

bool is_of_a_layer(Feature feature) {
  return feature == Feature::clearcoat_map || feature == Feature::clearcoat_roughness_map
         || feature == Feature::clearcoat_normal_map || feature == Feature::iridescence_map
         || feature == Feature::iridescence_thickness_map || feature == Feature::anisotropy_map;
}

std::vector<const MapKind*> maps_of(const scene::Scene& scene, const Material& m,
                                    const Primitive& primitive, const FrameFeatures& frame) {
  const Shading shading = shading_of(m, primitive);
  std::vector<const MapKind*> maps;
  for (const MapKind& map : map_kinds) {
    const Slot& slot = m.*map.slot;
    if (!has_uv_set(slot, primitive) || !has_image(scene, slot)) continue;
    if (has(frame.without, map.feature)) continue;
    if (map.feature != Feature::base_color_map && shading == Shading::unlit) continue;
    const bool bends = map.feature == Feature::normal_map
                       || map.feature == Feature::clearcoat_normal_map
                       || map.feature == Feature::anisotropy_map;
    if (bends && primitive.tangents == scene::none) continue;
    if (map.feature == Feature::anisotropy_map
            ? anisotropy_lobes(m, primitive) == 0 || has(frame.without, Feature::anisotropy)
            : !matters(map, m, shading, frame))
      continue;
    if (is_refractive(m) && is_of_a_layer(map.feature)) {
      // Glass fills the 16 textures of a stage that every device has with tables and pictures.
      note((m.name.empty() ? "an unnamed material" : "material '" + m.name + "'")
           + std::string(" is glass that is brushed or under a coat or a film: by its factors, the "
                         "maps of these are not drawn"));
      continue;
    }
    maps.push_back(&map);
  }
  return maps;
}

} // namespace

bool is_refractive(const Material& m) {
  // A map can only lower the factor of metal, whose default is 1.
  const bool all_metal = m.metallic >= 1.0f && !m.metallic_roughness_map;
  return m.transmission > 0.0f && !m.unlit && !m.conductor && !all_metal;
}

int anisotropy_lobes(const Material& m, const Primitive& primitive) {
  if (!(m.anisotropy_strength > 0.0f) || m.unlit || primitive.tangents == scene::none
      || m.distribution != scene::Distribution::ggx)
    return 0;
  if (is_refractive(m)) return 1;
  const auto widths = glsl::f32::ggxAnisoWidths(scene::microfacet_alpha(m), m.anisotropy_strength);
  return glsl::f32::stretchedParts(widths);
}

bool is_invisible(const Material& m, const Primitive& primitive) {
  return is_all_glass(m) && m.ior == 1.0f && !absorbs(m) && m.emissive == glm::vec3(0.0f)
         && glm::vec3(m.base_color) == glm::vec3(1.0f) && !m.base_color_map
         && primitive.colors == scene::none;
}

Features features_of(const scene::Scene& scene, const Material& m, const Primitive& primitive,
                     const FrameFeatures& frame_wants) {
  // Glass of IOR 1 reflects nothing and has no base.
  FrameFeatures frame = frame_wants;
  if (is_all_glass(m) && m.ior == 1.0f) frame.environment = frame.lights = false;

  Features features;
  std::vector<int>& sets = features.uv_sets;
  const auto set = [&](Feature feature, auto value) {
    set_value(features.key, feature, static_cast<int>(value));
  };
  for (const MapKind* map : maps_of(scene, m, primitive, frame)) {
    const int uv_set = (m.*map->slot).uv_set;
    auto found = std::ranges::find(sets, uv_set);
    if (found == sets.end()) {
      if (static_cast<int>(sets.size()) == max_uv_sets) {
        const auto number = std::ranges::find_if(
            scene.materials, [&](const Material& other) { return &other == &m; });
        std::string name(map->name); // glTF's, but for the last word
        name.replace(name.rfind("Map"), 3, "Texture");
        note(fmt::format(
            "materials[{}]{} reads more than {} sets of texture coordinates: its {}, on "
            "TEXCOORD_{}, is not drawn (truth has it)",
            number - scene.materials.begin(), m.name.empty() ? "" : " ('" + m.name + "')",
            max_uv_sets, name, uv_set));
        continue;
      }
      found = sets.insert(sets.end(), uv_set);
    }
    set(map->feature, 1 + (found - sets.begin())); // 0: no map
  }
  const Shading shading = shading_of(m, primitive);
  set(Feature::shading, shading);
  set(Feature::uv_sets, sets.size());
  set(Feature::alpha_mode, m.alpha_mode);
  const auto uses = [&](Feature feature) { return !has(frame.without, feature); };
  if (primitive.colors != scene::none) set(Feature::vertex_color, uses(Feature::vertex_color));
  if (shading == Shading::unlit) return features;

  set(Feature::distribution, m.distribution);
  // Roughness without a map is a width as well: one text for both.
  set(Feature::alpha_given,
      m.exact_alpha || value_of(features.key, Feature::metallic_roughness_map) == 0);
  set(Feature::correlated_smith,
      frame.correlated_smith && m.distribution == scene::Distribution::ggx);
  set(Feature::method, frame.method);
  const int brushed = uses(Feature::anisotropy) ? anisotropy_lobes(m, primitive) : 0;
  set(Feature::anisotropy, brushed);
  const bool coated = has_coat(m, frame);
  set(Feature::clearcoat, coated);
  set(Feature::iridescence, has_film(m, frame));
  set(Feature::diffuse_transmission, passes_diffuse(m));
  set(Feature::smooth, is_smooth(m, brushed, coated));
  set(Feature::environment, frame.environment);
  set(Feature::lights, frame.lights);
  set(Feature::multiple_scattering, frame.multiple_scattering);
  if (shading == Shading::dielectric || shading == Shading::mixed)
    // A coloured or weakened F0 has no IOR: Schlick's form is used.
    // glTF's ior 0 asks for F = 1 at every angle, which Schlick gives with F0 = 1.
    set(Feature::schlick_dielectric, m.specular != 1.0f || m.specular_color != glm::vec3(1.0f)
                                         || m.ior == 0.0f || m.specular_map
                                         || m.specular_color_map);
  if (const Transmission transmission = transmission_of(m); transmission != Transmission::none) {
    set(Feature::transmission, transmission);
    // `standard` needs no IOR.
    set(Feature::index_one, m.ior == 1.0f && frame.method != Method::standard);
    set(Feature::dispersion, m.dispersion > 0.0f && uses(Feature::dispersion));
    if (transmission == Transmission::solid)
      set(Feature::attenuation, absorbs(m) && uses(Feature::attenuation));
  }
  return features;
}

} // namespace gg::needs
