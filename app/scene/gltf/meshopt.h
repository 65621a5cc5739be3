// EXT_meshopt_compression: buffer views packed by meshoptimizer.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gg::scene::gltf {

struct Meshopt {
  enum class Mode { attributes, triangles, indices } mode;
  enum class Filter { none, octahedral, quaternion, exponential } filter;
  std::size_t count, stride; // of what comes out
};

// Reads the extension's JSON, already checked against the schema. Throws Error(input) where its
// members do not go together.
Meshopt meshopt_stream(const nlohmann::json& extension, const std::string& file,
                       const std::string& place);

// Unpacks to count * stride bytes. Throws Error(input) if `source` is damaged.
std::vector<std::byte> decode_meshopt(const Meshopt& stream, std::span<const std::byte> source,
                                      const std::string& file, const std::string& place);

} // namespace gg::scene::gltf
