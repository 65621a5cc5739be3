// Tangents by MikkTSpace's definition (M. S. Mikkelsen, "Simulation of Wrinkled Surfaces
// Revisited", 2008, §3.7-3.9), which glTF 2.0 §3.7.2.1 prescribes where a file has none: normal
// maps are baked against it.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gg::scene {

// One tangent per corner: xyz unit and perpendicular to the corner's normal, pointing along +u; w =
// +1 or -1 such that the bitangent is cross(normal, xyz) * w, pointing along -v (glTF's images have
// v downwards, the definition has it upwards). `positions` and `normals` (unit) have three floats
// per vertex, `uvs` two; `indices` three corners per triangle. Where the texture coordinates have
// no extent the tangent is an arbitrary one perpendicular to the normal, with w = 1.
std::vector<glm::vec4> corner_tangents(std::span<const float> positions,
                                       std::span<const float> normals, std::span<const float> uvs,
                                       std::span<const std::uint32_t> indices);

// Corners as vertices: those that agree in vertex and tangent share one.
struct Split {
  std::vector<std::uint32_t> indices; // into the new vertices
  std::vector<std::uint32_t> source;  // the old vertex of each new one
  std::vector<float> tangents;        // four floats per new vertex
};
Split split_vertices(std::span<const std::uint32_t> indices, std::span<const glm::vec4> tangents);

// A unit vector perpendicular to the unit vector n.
glm::vec3 perpendicular(const glm::vec3& n);

} // namespace gg::scene
