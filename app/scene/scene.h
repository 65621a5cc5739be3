// What is drawn: geometry, materials, cameras and lights, as read from glTF and independent of any
// graphics API. Units are glTF's: metres, radians, right-handed, +Y up; a camera looks down its -Z.
// Colours are linear Rec.709.
#pragma once

#include "image/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::scene {

using Index = std::int32_t;
inline constexpr Index none = -1;

// A run of values decoded to floats: positions (3), normals (3), tangents (4: xyz and the sign of
// the bitangent), texture coordinates (2), colours (4). Streams are shared: primitives that read
// the same accessors name the same stream.
struct Stream {
  int components = 0;
  std::vector<float> values;
  std::size_t count() const { return values.size() / static_cast<std::size_t>(components); }
};

// A list of triangles: three entries each (strips and fans are unrolled), counter-clockwise seen
// from the front.
using Indices = std::vector<std::uint32_t>;

struct Bounds {
  glm::vec3 low{INFINITY}, high{-INFINITY};
  bool empty() const { return !(low.x <= high.x); }
  void include(const glm::vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  glm::vec3 centre() const { return 0.5f * (low + high); }
  float radius() const { return 0.5f * glm::length(high - low); }
};

// One draw. Stream members index Scene::streams, `none` where the file has none; normals are always
// there, tangents where the material needs them and the texture coordinates allow them.
struct Primitive {
  Index positions = none, normals = none, tangents = none, colors = none;
  std::vector<Index> uvs; // TEXCOORD_0, TEXCOORD_1, ...
  Index indices = none;   // into Scene::indices
  Index material = none;  // into Scene::materials; always valid after loading
  Bounds bounds;          // in mesh space
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

// A mesh placed in the world.
struct Instance {
  Index mesh = none;
  glm::mat4 world{1.0f};
  bool mirrored = false; // world has a negative determinant: the front faces are clockwise
  std::string name;
};

enum class Wrap { repeat, mirrored_repeat, clamp };
enum class Filter { nearest, linear };

struct Sampler {
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
  Filter magnify = Filter::linear, minify = Filter::linear, between_levels = Filter::linear;
  bool mipmaps = true;
};

struct Texture {
  Index image = none; // into Scene::images
  Sampler sampler;
};

// A material's use of a texture: which one, which coordinates, and KHR_texture_transform as uv' =
// transform * (u, v, 1).
struct Slot {
  Index texture = none;
  int uv_set = 0;
  glm::mat3 transform{1.0f};
  float scale = 1.0f; // normal scale or occlusion strength
  explicit operator bool() const { return texture != none; }
};

enum class AlphaMode { opaque, mask, blend };
enum class Distribution { ggx, beckmann, phong };

// A metal by its complex index n - i k, per linear Rec.709 channel.
struct Conductor {
  glm::vec3 n{1.0f}, k{0.0f};
};

// glTF 2.0 metallic-roughness with extensions. `alpha` (width of D) is roughness squared:
// microfacet_alpha() is the only place that knows.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  float metallic = 1.0f, roughness = 1.0f;
  glm::vec3 emissive{0.0f}; // times emissive_strength already, in cd/m²-like scene units
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false, unlit = false;
  float ior = 1.5f;      // KHR_materials_ior; 0 is glTF's "always reflect"
  float specular = 1.0f; // KHR_materials_specular
  glm::vec3 specular_color{1.0f};
  float transmission = 0.0f;             // KHR_materials_transmission
  float thickness = 0.0f;                // KHR_materials_volume: mesh units; 0 = thin-walled
  float attenuation_distance = INFINITY; // metres
  glm::vec3 attenuation_color{1.0f};
  float dispersion = 0.0f; // KHR_materials_dispersion: 20 / Abbe number
  float anisotropy_strength = 0.0f, anisotropy_rotation = 0.0f;
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  float iridescence = 0.0f, iridescence_ior = 1.3f; // KHR_materials_iridescence: a thin film
  glm::vec2 iridescence_thickness{100.0f, 400.0f};  // nm: where its map is 0, and where it is 1
  float diffuse_transmission = 0.0f;                // KHR_materials_diffuse_transmission
  glm::vec3 diffuse_transmission_color{1.0f};

  Slot base_color_map, metallic_roughness_map, normal_map, occlusion_map, emissive_map;
  Slot specular_map, specular_color_map, transmission_map, thickness_map, anisotropy_map;
  Slot clearcoat_map, clearcoat_roughness_map, clearcoat_normal_map;
  Slot iridescence_map, iridescence_thickness_map;
  Slot diffuse_transmission_map, diffuse_transmission_color_map;

  // Set by presets (or glTF extras): what glTF itself cannot say.
  std::optional<Conductor>
      conductor; // exact Fresnel of a metal, in place of base_color where metallic = 1
  std::optional<float>
      back_alpha; // width of D where light leaves a solid, if not that of the front
  Distribution distribution = Distribution::ggx;
  std::optional<float> exact_alpha; // width of D given directly, in place of roughness²
  std::string preset;               // its name, for reports
};

// The width of D: roughness² (glTF), or what a preset gave. In [0, 1].
float microfacet_alpha(const Material& material);

enum class LightKind { directional, point, spot };

// KHR_lights_punctual. Directional: lux; point and spot: candela.
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  glm::vec3 intensity{1.0f};                              // colour times intensity
  float range = INFINITY;                                 // metres; the light is 0 beyond
  float inner_cone = 0.0f, outer_cone = 0.785398163f;     // radians from the axis
  glm::vec3 position{0.0f}, direction{0.0f, 0.0f, -1.0f}; // world
};

struct Camera {
  std::string name;
  glm::mat4 world{1.0f}; // camera to world, rigid
  bool orthographic = false;
  float fovy = 0.785398163f;     // radians
  glm::vec2 magnification{1.0f}; // orthographic half-extents, metres
  std::optional<float> aspect;   // width / height, if the file fixes one
  float near = 0.0f, far = 0.0f; // metres; far 0 = infinite
  std::string fault;             // what is wrong with it in the file: it cannot be looked through
};

// The animation that a scene is posed by. Seconds.
struct Posed {
  std::string animation;         // its name, or its index if it has none
  float time = 0.0f, end = 0.0f; // when, and when its last key is
};

struct Scene {
  std::string path;
  std::optional<Posed> posed;          // nothing: the nodes as they stand in the file
  std::vector<std::string> animations; // of the file: names, or indices of those that have none
  std::vector<Stream> streams;
  std::vector<Indices> indices;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<std::shared_ptr<const image::Image8>>
      images; // by glTF index; null if nothing reads it
  std::vector<Texture> textures;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  Bounds bounds; // of all instances, world

  std::size_t triangle_count() const; // as drawn: counted once per instance
};

} // namespace gg::scene
