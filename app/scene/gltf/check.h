// What the JSON of a glTF 2.0 file must look like before anything is built from it.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace gg::scene::gltf {

// Checks types, required members, ranges, and that every index points to something that exists, for
// all that this program reads (core glTF 2.0 and the extensions in extensions.h). Throws
// Error(input) naming `file` and the place, such as "nodes[2].mesh". What it lets through, tinygltf
// reads without a fault, and the code that follows need not check again.
void check(const nlohmann::json& json, const std::string& file);

// Checks one of "animations", which check() leaves alone: a file is drawn whatever is wrong with what is not played.
void check_animation(const nlohmann::json& root, std::size_t index, const std::string& file);

// What check() would say of one entry of "materials" or "cameras"; nothing if it is sound.
std::optional<std::string> fault_of(const nlohmann::json& root, const char* array,
                                    std::size_t index, const std::string& file);

} // namespace gg::scene::gltf
