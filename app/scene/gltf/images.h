// Textures, samplers and the pictures that something reads.
#pragma once

#include "scene/gltf/document.h"
#include "scene/scene.h"

#include <vector>

namespace gg::scene::gltf {

// Fills Scene::textures (by glTF index) and makes room for Scene::images. A texture takes
// the WebP or plain image that it has, else the KTX2 one; one that has none gets `none`.
void read_textures(const Document& document, Scene& scene);

// Decodes the images that the slots of these materials reach, several at a time. Throws
// Error(input) for a broken image, Error(unsupported) for KTX2 where there is no libktx.
void decode_images(Document& document, const std::vector<bool>& material_is_used, Scene& scene);

// Every texture slot of a material.
std::vector<Slot*> slots(Material& material);

} // namespace gg::scene::gltf
