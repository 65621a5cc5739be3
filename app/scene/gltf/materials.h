// glTF materials -> Scene::materials.
#pragma once

#include "scene/gltf/document.h"
#include "scene/scene.h"

namespace gg::scene::gltf {

// Material `index` of the file; texture slots name Scene::textures by glTF index.
Material read_material(const Document& document, int index);

// What a primitive without a material gets: glTF's defaults.
Material default_material();

} // namespace gg::scene::gltf
