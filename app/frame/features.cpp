#include "frame/features.h"

#include <algorithm>
#include <cmath>

namespace gg::frame {
namespace {

using scene::Material;
using scene::Primitive;
using scene::Slot;

bool reads(const Slot& slot, const Primitive& primitive) {
  return slot && slot.uv_set < static_cast<int>(primitive.uvs.size())
         && primitive.uvs[static_cast<std::size_t>(slot.uv_set)] != scene::none;
}

Shading shading_of(const Material& m, const Primitive& primitive) {
  if (m.unlit) return Shading::unlit;
  if (m.conductor) return Shading::conductor;
  if (m.metallic <= 0.0f) return Shading::dielectric;
  // A map can only lower the factor, so it makes a mixture of any metal.
  if (reads(m.metallic_roughness_map, primitive) || m.metallic < 1.0f) return Shading::mixed;
  return Shading::metal;
}

Transmission transmission_of(const Material& m) {
  if (!is_refractive(m)) return Transmission::none;
  return m.thickness > 0.0f ? Transmission::solid : Transmission::thin;
}

} // namespace

bool is_refractive(const Material& m) {
  return m.transmission > 0.0f && !m.unlit && !m.conductor && m.metallic < 1.0f;
}

std::vector<int> uv_sets_of(const Material& m, const Primitive& primitive) {
  std::vector<int> sets;
  for (const Slot* slot : {&m.base_color_map, &m.metallic_roughness_map, &m.normal_map,
                           &m.occlusion_map, &m.emissive_map, &m.specular_map,
                           &m.specular_color_map, &m.transmission_map, &m.thickness_map})
    if (reads(*slot, primitive) && std::ranges::find(sets, slot->uv_set) == sets.end()
        && static_cast<int>(sets.size()) < max_uv_sets)
      sets.push_back(slot->uv_set);
  return sets;
}

FeatureKey features_of(const Material& m, const Primitive& primitive, const FrameFeatures& frame) {
  FeatureKey key{};
  const auto set = [&](Feature feature, auto value) {
    key[static_cast<std::size_t>(feature)] = static_cast<std::int32_t>(value);
  };
  const std::vector<int> sets = uv_sets_of(m, primitive);
  // 0 without a map, else 1 + the shader's number of its set.
  const auto map = [&](Feature feature, const Slot& slot) {
    if (!reads(slot, primitive)) return;
    const auto found = std::ranges::find(sets, slot.uv_set);
    if (found != sets.end()) set(feature, 1 + (found - sets.begin()));
  };
  const Shading shading = shading_of(m, primitive);
  set(Feature::shading, shading);
  set(Feature::uv_sets, sets.size());
  set(Feature::alpha_mode, m.alpha_mode);
  map(Feature::base_color_map, m.base_color_map);
  if (primitive.colors != scene::none) set(Feature::vertex_color, true);
  if (shading == Shading::unlit) return key;

  map(Feature::metallic_roughness_map, m.metallic_roughness_map);
  if (primitive.tangents != scene::none) map(Feature::normal_map, m.normal_map);
  map(Feature::occlusion_map, m.occlusion_map);
  map(Feature::emissive_map, m.emissive_map);
  set(Feature::distribution, m.distribution);
  set(Feature::alpha_given, m.exact_alpha.has_value());
  set(Feature::correlated_smith, frame.correlated_smith);
  set(Feature::method, frame.method);
  set(Feature::environment, frame.environment);
  set(Feature::lights, frame.lights);
  set(Feature::multiple_scattering, frame.multiple_scattering);
  if (shading == Shading::dielectric || shading == Shading::mixed) {
    map(Feature::specular_map, m.specular_map);
    map(Feature::specular_color_map, m.specular_color_map);
    // A coloured or weakened F0 is no index of refraction: Schlick's form is all that is left.
    // glTF's ior 0 asks for F = 1 at every angle, which Schlick gives with F0 = 1.
    set(Feature::schlick_dielectric, m.specular != 1.0f || m.specular_color != glm::vec3(1.0f)
                                         || m.ior == 0.0f || m.specular_map
                                         || m.specular_color_map);
  }
  if (const Transmission transmission = transmission_of(m); transmission != Transmission::none) {
    set(Feature::transmission, transmission);
    map(Feature::transmission_map, m.transmission_map);
    set(Feature::index_one, m.ior == 1.0f);
    set(Feature::dispersion, m.dispersion > 0.0f);
    if (transmission == Transmission::solid) {
      map(Feature::thickness_map, m.thickness_map);
      set(Feature::attenuation,
          std::isfinite(m.attenuation_distance) && m.attenuation_color != glm::vec3(1.0f));
    }
  }
  return key;
}

std::vector<gpu::Constant> constants_of(const FeatureKey& key) {
  std::vector<gpu::Constant> constants;
  for (std::uint32_t id = 0; id < key.size(); ++id)
    constants.push_back(gpu::constant(id, key[id]));
  return constants;
}

} // namespace gg::frame
