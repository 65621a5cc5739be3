#include "scene/gltf_file.h"

#include "core/files.h"
#include "support/scratch.h"

#include <glm/gtc/type_ptr.hpp>

namespace gg::test {
namespace {

void append(std::string& text, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8)
    text += static_cast<char>(value >> shift & 0xFF);
}

void append_chunk(std::string& text, std::uint32_t type, std::string content, char padding) {
  while (content.size() % 4 != 0)
    content += padding;
  append(text, static_cast<std::uint32_t>(content.size()));
  append(text, type);
  text += content;
}

} // namespace

GltfFile::GltfFile()
    : json({{"asset", {{"version", "2.0"}}},
            {"buffers", {{{"byteLength", 0}}}},
            {"scenes", {{{"nodes", nlohmann::json::array()}}}},
            {"scene", 0}}) {}

int GltfFile::view(const void* data, std::size_t size, int stride) {
  bytes.resize((bytes.size() + 3) / 4 * 4);
  const std::size_t offset = bytes.size();
  bytes.resize(offset + size);
  std::memcpy(bytes.data() + offset, data, size);
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
  if (stride != 0) json["bufferViews"].back()["byteStride"] = stride;
  json["buffers"][0]["byteLength"] = bytes.size();
  return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfFile::mesh(const nlohmann::json& primitive) {
  json["meshes"].push_back({{"primitives", {primitive}}});
  const auto mesh = json["meshes"].size() - 1;
  json["nodes"].push_back({{"mesh", mesh}});
  const auto node = json["nodes"].size() - 1;
  json["scenes"][0]["nodes"].push_back(node);
  return static_cast<int>(node);
}

int GltfFile::triangle() {
  const int positions = accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  return mesh({{"attributes", {{"POSITION", positions}}}});
}

std::filesystem::path GltfFile::save(const std::string& name) const {
  return scratch_file(name, glb(json.dump(), bytes));
}

std::filesystem::path GltfFile::save_text(const std::string& name) const {
  nlohmann::json text = json;
  text["buffers"][0]["uri"] =
      "data:application/octet-stream;base64," + base64(bytes.data(), bytes.size());
  return scratch_file(name, text.dump());
}

std::string glb(const std::string& json, const std::vector<std::byte>& binary) {
  std::string chunks;
  append_chunk(chunks, 0x4E4F534A, json, ' ');
  append_chunk(chunks, 0x004E4942, {reinterpret_cast<const char*>(binary.data()), binary.size()},
               '\0');
  std::string text = "glTF";
  append(text, 2);
  append(text, static_cast<std::uint32_t>(12 + chunks.size()));
  return text + chunks;
}

std::string base64(const void* data, std::size_t size) {
  static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = static_cast<const unsigned char*>(data);
  std::string text;
  for (std::size_t i = 0; i < size; i += 3) {
    const std::size_t left = std::min<std::size_t>(3, size - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < left ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= left ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

const std::vector<float>& values(const scene::Scene& scene, scene::Index stream) {
  return scene.streams.at(static_cast<std::size_t>(stream)).values;
}

const scene::Primitive& first(const scene::Scene& scene) {
  return scene.meshes.at(0).primitives.at(0);
}

glm::vec3 vec3_at(const scene::Scene& scene, scene::Index stream, std::size_t vertex) {
  const auto& s = scene.streams.at(static_cast<std::size_t>(stream));
  return glm::make_vec3(s.values.data() + vertex * static_cast<std::size_t>(s.components));
}

std::vector<glm::vec3> corners(const scene::Scene& scene, const scene::Primitive& primitive) {
  std::vector<glm::vec3> result;
  for (const std::uint32_t i : scene.indices.at(static_cast<std::size_t>(primitive.indices)))
    result.push_back(vec3_at(scene, primitive.positions, i));
  return result;
}

std::filesystem::path asset(const std::string& name) {
  return home_directory() / "assets" / name;
}

} // namespace gg::test
