// Accessors decoded to plain numbers: every component type, normalised or not, interleaved, sparse,
// or without data (zeros), as glTF 2.0 §3.6.2 says.
#pragma once

#include "scene/gltf/document.h"

#include <cstdint>
#include <vector>

namespace gg::scene::gltf {

// The number of values per element: 1 for SCALAR, 3 for VEC3, 16 for MAT4, ...
int component_count(const tinygltf::Accessor& accessor);

// count * component_count floats; matrices column by column without their padding. Integers are
// normalised if the accessor says so, else converted. Throws Error(input) naming the accessor if it
// reaches beyond its buffer view, is not finite, or declares more than the file can hold.
std::vector<float> read_floats(Document& document, int accessor);

// As read_floats for unsigned integers: indices and joints. Throws Error(input) if the component
// type is another.
std::vector<std::uint32_t> read_integers(Document& document, int accessor);

// An integer component as a float, normalised by its type (§3.6.2.2: signed values are
// max(c / max, -1)).
float normalised(std::int64_t value, int component_type);

} // namespace gg::scene::gltf
