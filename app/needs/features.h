// What a draw's shaders are specialised on: the specialization constants of
// shaders/stages/material_features.glsl.
#pragma once

#include "scene/scene.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

namespace gg::needs {

// How the environment and other bodies are looked up. Any number without a name below is fis(N).
enum class Method : int {
  standard =
      0, // the usual approximation: split sum along the mirror direction; one interface, its LOD by IOR
  lobes1 = 1, // so many fitted Gaussians
  lobes2 = 2,
  lobes3 = 3,
  lobes4 = 4
};
// Lobes that a method's tables have: 0 for those that read none.
constexpr int lobes_of(Method method) {
  const int number = static_cast<int>(method);
  return number >= 1 && number <= 4 ? number : 0;
}
// Importance sampling with N directions, each reading the level of its own solid angle.
inline constexpr int first_fis = 100;
constexpr Method fis(int n) {
  return static_cast<Method>(first_fis + n);
}

// The numbers of the constants, in the order of material_features.glsl.
enum class Feature : std::uint32_t {
  base_color_map,
  metallic_roughness_map,
  normal_map,
  occlusion_map,
  emissive_map,
  specular_map,
  specular_color_map,
  vertex_color,
  alpha_mode,
  shading,
  distribution,
  correlated_smith,
  method,
  environment,
  lights,
  alpha_given,
  multiple_scattering,
  schlick_dielectric,
  uv_sets,
  transmission,
  transmission_map,
  thickness_map,
  dispersion,
  index_one,
  attenuation,
  holds_opaque,
  interior_pairs,
  lobe_count,
  seen_from_within,
  smooth,
  neighbours, // of NeighbourKind
  own_proxy,
  clearcoat,
  clearcoat_map,
  clearcoat_roughness_map,
  clearcoat_normal_map,
  anisotropy, // lobes in place of the stretched one; 0: none
  anisotropy_map,
  iridescence,
  iridescence_map,
  iridescence_thickness_map,
  faces_differ, // base colour or clear share vary over the faces of a solid
  diffuse_transmission,
  diffuse_transmission_map,
  diffuse_transmission_color_map,
  hollows,                 // vertices hold the share of their cosine lobe that meets their own mesh
  interpolated_neighbours, // what neighbours add is smooth enough for a lower rate in most places
  count
};
using FeatureSet = std::bitset<static_cast<std::size_t>(Feature::count)>;
inline bool has(const FeatureSet& set, Feature feature) {
  return set[static_cast<std::size_t>(feature)];
}

// What every draw of a frame has in common.
struct FrameFeatures {
  Method method = Method::lobes1;
  bool correlated_smith = false, multiple_scattering = false;
  bool environment = true, lights = false;
  FeatureSet without; // of those of left_out.h
};

enum class Shading { unlit, dielectric, metal, mixed, conductor };
enum class Transmission { none, thin, solid };
// Kinds of a draw's neighbours, as bits.
enum NeighbourKind {
  some_spheres = 1,
  some_rectangles = 2,
  some_glass = 4,
  some_opaque = 8 // or in part
};

// How many lobes of isotropic surfaces replace that of a brushed one (environment/stretched_lobe.glsl): none for one
// that is not brushed, 1 for glass (stages/brushed_glass.glsl). The error by their number: tests/bench/stretched_lobes.cpp.
int anisotropy_lobes(const scene::Material& material, const scene::Primitive& primitive);

// True for a material that light passes by refraction. Its alpha mode does not matter.
bool is_refractive(const scene::Material& material);

// True for glass of IOR 1 that neither tints, absorbs nor glows: it shows what is behind it, to the bit, so it need not
// be drawn.
bool is_invisible(const scene::Material& material, const scene::Primitive& primitive);

// One value per Feature: the key under which a pipeline is kept.
using FeatureKey = std::array<std::int32_t, static_cast<std::size_t>(Feature::count)>;
constexpr int value_of(const FeatureKey& key, Feature feature) {
  return key[static_cast<std::size_t>(feature)];
}
constexpr void set_value(FeatureKey& key, Feature feature, int value) {
  key[static_cast<std::size_t>(feature)] = value;
}

// A shader reads at most this many sets of texture coordinates.
inline constexpr int max_uv_sets = 4;

// A map of a material, under the name that shaders give it.
struct MapKind {
  const char* name;
  scene::Slot scene::Material::*slot;
  Feature feature;
  bool srgb;
};
inline constexpr std::array<MapKind, 17> map_kinds = {{
    {"baseColorMap", &scene::Material::base_color_map, Feature::base_color_map, true},
    {"metallicRoughnessMap", &scene::Material::metallic_roughness_map,
     Feature::metallic_roughness_map, false},
    {"normalMap", &scene::Material::normal_map, Feature::normal_map, false},
    {"occlusionMap", &scene::Material::occlusion_map, Feature::occlusion_map, false},
    {"emissiveMap", &scene::Material::emissive_map, Feature::emissive_map, true},
    {"specularMap", &scene::Material::specular_map, Feature::specular_map, false},
    {"specularColorMap", &scene::Material::specular_color_map, Feature::specular_color_map, true},
    {"transmissionMap", &scene::Material::transmission_map, Feature::transmission_map, false},
    {"thicknessMap", &scene::Material::thickness_map, Feature::thickness_map, false},
    {"clearcoatMap", &scene::Material::clearcoat_map, Feature::clearcoat_map, false},
    {"clearcoatRoughnessMap", &scene::Material::clearcoat_roughness_map,
     Feature::clearcoat_roughness_map, false},
    {"clearcoatNormalMap", &scene::Material::clearcoat_normal_map, Feature::clearcoat_normal_map,
     false},
    {"anisotropyMap", &scene::Material::anisotropy_map, Feature::anisotropy_map, false},
    {"iridescenceMap", &scene::Material::iridescence_map, Feature::iridescence_map, false},
    {"iridescenceThicknessMap", &scene::Material::iridescence_thickness_map,
     Feature::iridescence_thickness_map, false},
    {"diffuseTransmissionMap", &scene::Material::diffuse_transmission_map,
     Feature::diffuse_transmission_map, false},
    {"diffuseTransmissionColorMap", &scene::Material::diffuse_transmission_color_map,
     Feature::diffuse_transmission_color_map, true},
}};

struct Features {
  FeatureKey key{};
  std::vector<int> uv_sets; // element k feeds the shader's k-th set
};
// The features of one primitive: only what its material and its streams make a difference with. What depends on other
// draws or on the camera (holds_opaque, interior_pairs, seen_from_within, neighbours) is left at 0.
Features features_of(const scene::Scene& scene, const scene::Material& material,
                     const scene::Primitive& primitive, const FrameFeatures& frame);

} // namespace gg::needs
