// glTF files made by tests.
#pragma once

#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace gg::test {

// Of a few float operations on numbers of about 1: ten times their last bit.
inline constexpr float rounding = 1e-6f;

template <class T>
constexpr int component_type() {
  if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
  if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
  if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
  if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
  if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
  return 5126;
}

inline std::size_t width_of(const std::string& type) {
  return type == "SCALAR" ? 1u
         : type == "MAT4" ? 16u
         : type == "MAT3" ? 9u
         : type == "MAT2" ? 4u
                          : static_cast<std::size_t>(type[3] - '0');
}

// JSON and one buffer, with shorthands for what every file needs. `json` is public: tests change
// what they are about.
class GltfFile {
public:
  nlohmann::json json;
  std::vector<std::byte> bytes;

  GltfFile();

  // Appends the bytes (aligned to 4) as a buffer view; stride 0 = packed.
  int view(const void* data, std::size_t size, int stride = 0);

  // Appends packed values as an accessor.
  template <class T>
  int accessor(const std::vector<T>& values, const std::string& type, bool normalised = false) {
    const int v = view(values.data(), values.size() * sizeof(T));
    json["accessors"].push_back({{"bufferView", v},
                                 {"componentType", component_type<T>()},
                                 {"count", values.size() / width_of(type)},
                                 {"type", type}});
    if (normalised) json["accessors"].back()["normalized"] = true;
    return static_cast<int>(json["accessors"].size()) - 1;
  }

  // Appends a mesh of one primitive, and a node that places it. Returns the node.
  int mesh(const nlohmann::json& primitive);

  // One triangle (0,0,0) (1,0,0) (0,1,0) without normals. Returns the node.
  int triangle();

  nlohmann::json& primitive(int mesh = 0) { return json["meshes"][mesh]["primitives"][0]; }

  // Writes a .glb into the test's scratch directory.
  std::filesystem::path save(const std::string& name = "scene.glb") const;
  // Writes a .gltf whose buffer is a data: URI.
  std::filesystem::path save_text(const std::string& name = "scene.gltf") const;
};

std::string glb(const std::string& json, const std::vector<std::byte>& binary);
std::string base64(const void* data, std::size_t size);

// Shorthands to look at what was loaded.
const std::vector<float>& values(const scene::Scene& scene, scene::Index stream);
const scene::Primitive& first(const scene::Scene& scene);
glm::vec3 vec3_at(const scene::Scene& scene, scene::Index stream, std::size_t vertex);

// The position of each corner, in the order of the triangle list: independent of how vertices are
// shared.
std::vector<glm::vec3> corners(const scene::Scene& scene, const scene::Primitive& primitive);

// A file of assets/.
std::filesystem::path asset(const std::string& name);

} // namespace gg::test
