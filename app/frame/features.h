// What a draw's shaders are specialised on: the specialization constants of
// shaders/stages/material_features.glsl.
#pragma once

#include "gpu/types.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>

namespace gg::frame {

// How the environment's reflection is looked up.
enum class Method {
  standard, // what peers do: split sum along the mirror direction
  lobes1    // one fitted Gaussian
};

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
  count
};
enum class Shading { unlit, dielectric, metal, mixed, conductor };

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
