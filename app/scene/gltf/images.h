// Textures, samplers and the pictures that something reads.
#pragma once

#include "scene/gltf/document.h"
#include "scene/scene.h"

#include <vector>

namespace gg::scene::gltf {

// Fills Scene::textures (by glTF index) and makes room for Scene::images. A texture in a format
// that is not read (KTX2) falls back to the plain image beside it; one that has none gets `none`.
void read_textures(const Document& document, Scene& scene);

// Decodes the images that the slots of these materials reach, several at a time. Throws
// Error(input) for a broken image, Error(unsupported) for a texture that is only there as KTX2.
void decode_images(Document& document, const std::vector<bool>& material_is_used, Scene& scene);

// Every texture slot of a material.
std::vector<Slot*> slots(Material& material);

} // namespace gg::scene::gltf
