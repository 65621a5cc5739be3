// What a draw's shaders are specialised on: the specialization constants of
// shaders/stages/material_features.glsl.
#pragma once

#include "gpu/types.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>

namespace gg::frame {

// How light from the surroundings is looked up. Any number that is no name below is fis(N).
enum class Method : int {
  standard =
      0, // what peers do: split sum along the mirror direction; one interface, its LOD by index
  lobes1 = 1, // so many fitted Gaussians
  lobes2 = 2,
  lobes3 = 3,
  lobes4 = 4
};
// Taps that a method's tables have: 0 for those that read none.
constexpr int taps_of(Method method) {
  const int number = static_cast<int>(method);
  return number >= 1 && number <= 4 ? number : 0;
}
// Importance sampling with N directions, each reading the level of its own solid angle.
inline constexpr int first_fis = 100;
constexpr Method fis(int n) {
  return static_cast<Method>(first_fis + n);
}

// What the frame as a whole asks of every draw.
struct FrameFeatures {
  Method method = Method::lobes1;
  bool correlated_smith = false, multiple_scattering = false;
  bool environment = true, lights = false;
};

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
  count
};
enum class Shading { unlit, dielectric, metal, mixed, conductor };
enum class Transmission { none, thin, solid };

// True for a material that light passes by refraction. Its alpha mode does not matter.
bool is_refractive(const scene::Material& material);

// One value per Feature: the key under which a pipeline is kept.
using FeatureKey = std::array<std::int32_t, static_cast<std::size_t>(Feature::count)>;

// A shader reads at most this many sets of texture coordinates.
inline constexpr int max_uv_sets = 4;

// The sets that the material's maps read from this primitive, without repetition: element k feeds
// the shader's k-th set. A map whose set the primitive lacks is left out, as glTF has no meaning
// for it.
std::vector<int> uv_sets_of(const scene::Material& material, const scene::Primitive& primitive);

// The features of one primitive: only what its material and its streams make a difference with.
FeatureKey features_of(const scene::Material& material, const scene::Primitive& primitive,
                       const FrameFeatures& frame);

std::vector<gpu::Constant> constants_of(const FeatureKey& key);

} // namespace gg::frame
