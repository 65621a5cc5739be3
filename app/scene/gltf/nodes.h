// The node hierarchy -> instances, cameras and lights in the world.
#pragma once

#include "scene/gltf/document.h"

#include <glm/glm.hpp>

#include <vector>

namespace gg::scene::gltf {

// A node of the scene with its place in the world.
struct Placed {
  int node;
  glm::mat4 world;
};

// The nodes of the file's default scene (else its first, else every root), parents before children,
// in file order. `worlds` of nodes outside the scene are asked for by skins: see world_of. Throws
// Error(input) for a node with two parents or that is its own ancestor, and for a transform that is
// not finite.
class Hierarchy {
public:
  explicit Hierarchy(const Document& document);
  const std::vector<Placed>& placed() const { return placed_; }
  const glm::mat4& world_of(int node) const { return worlds_[static_cast<std::size_t>(node)]; }

private:
  std::vector<Placed> placed_;
  std::vector<glm::mat4> worlds_;
};

} // namespace gg::scene::gltf
