// The outside of a glTF file: .gltf text or .glb chunks, and the files it refers to.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gg::scene::gltf {

struct Container {
  std::string name;                // of the file, for messages
  std::filesystem::path directory; // that relative URIs start from
  nlohmann::json json;
  std::vector<std::byte> bytes;                      // the whole file
  std::optional<std::span<const std::byte>> payload; // the BIN chunk of a .glb
};

// Opens a .gltf or .glb (told apart by content, not by name). Throws Error(input) naming the place
// if the file is missing, truncated, not glTF 2, not JSON, or nested deeper than any real file is.
Container open_container(const std::filesystem::path& path);

// What a URI stands for: the bytes of a data: URI, or of a file in the folder of the scene or below it. "../" may lead out
// of that folder as far as the user named folders: opened as "model/scene/a.gltf", a scene may read what is in
// model/; as "a.gltf", only what is beside it. A path from the root names too much: there it is the folder around
// the scene's own. Throws Error(input) naming the file and `place` if it is broken, missing, remote, or points elsewhere.
std::vector<std::byte> fetch(const std::string& uri, const Container& container,
                             const std::string& place);

} // namespace gg::scene::gltf
