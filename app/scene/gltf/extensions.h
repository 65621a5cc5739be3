// Which glTF extensions are known here.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace gg::scene::gltf {

// Throws Error(unsupported) naming the first required extension that is not known; says once, by
// name, which of the others are in use and ignored.
void check_extensions(const nlohmann::json& json, const std::string& file);

} // namespace gg::scene::gltf
