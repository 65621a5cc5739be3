// Presets in a material's extras (the keys are in scene/apply.h).
#pragma once

#include "scene/apply.h"
#include "scene/gltf/document.h"

#include <optional>

namespace gg::scene::gltf {

// What materials[index].extras.groundglass asks for, if it is there. Throws Error(input) if it is
// not an object of strings, numbers and arrays of numbers.
std::optional<Setting> setting_in_extras(const Document& document, int index);

} // namespace gg::scene::gltf
