// Animations: glTF 2.0 §3.11.
#pragma once

#include "scene/gltf/document.h"
#include "scene/load.h"

namespace gg::scene::gltf {

// Of the file's animations, in its order; of one without a name, its index.
std::vector<std::string> animation_names(const Document& document);

// Puts translation, rotation, scale and morph weights of the document's nodes where its animation has
// them at the instant. Before its first key and after its last a channel keeps the value of that key.
// What else a channel may aim at is said once and ignored. Throws Error(usage) if there is no such
// animation, naming those that there are; Error(input) if it is not sound.
Posed pose_at(Document& document, const Instant& instant);

} // namespace gg::scene::gltf
