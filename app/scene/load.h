// From a glTF file to a Scene.
#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace gg::scene {

// Loads a .gltf or .glb: the default scene at its rest pose (nodes as they stand in the file, skins
// and default morph weights applied), with normals and, where a material needs them, tangents. Only
// images that a drawn material uses are decoded. Says once on stderr what is ignored.
//
// Throws Error(input) naming the file, the place in it and a remedy if anything is missing or
// wrong, Error(unsupported) if the file requires what this program does not read.
Scene load(const std::filesystem::path& path);

} // namespace gg::scene
