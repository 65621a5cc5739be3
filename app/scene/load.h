// From a glTF file to a Scene.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::scene {

// A moment of an animation.
struct Instant {
  float time = 0.0f;     // seconds; before its first key and after its last it stands still
  std::string animation; // by name or index; empty: the file's first
};

// Loads a .gltf or .glb: the default scene at its rest pose (nodes as they stand in the file, skins
// and default morph weights applied) or as an animation poses it, with normals and, where a material needs them, tangents. Only
// images that a drawn material uses are decoded. Says once on stderr what is ignored.
//
// Throws Error(input) naming the file, the place in it and a remedy if anything is missing or
// wrong, Error(unsupported) if the file requires what this program does not read, Error(usage) if
// there is no such animation.
Scene load(const std::filesystem::path& path, const std::optional<Instant>& instant = {});

// The same file at several moments: it is read, checked and parsed once, and its images are decoded once.
class File {
public:
  explicit File(const std::filesystem::path& path);
  ~File();
  // As load(). What one pose unpacks does not count against the next.
  Scene at(const std::optional<Instant>& instant);

private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

} // namespace gg::scene
