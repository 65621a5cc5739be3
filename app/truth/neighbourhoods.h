// Where in space the triangles of more than one part are: a grid over the scene that says quickly that
// there are none but one part's.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gg::truth {

class Neighbourhoods {
public:
  // Bounds of all triangles that will be added.
  explicit Neighbourhoods(const scene::Bounds& bounds);

  // A triangle of the part with this number, by its own bounds, which have a margin for what counts as near.
  void add(std::uint32_t part, const scene::Bounds& triangle);
  // After the last triangle: `several` may be asked.
  void close();
  // May triangles of several parts be near a point of a triangle that was added?
  bool several(const glm::dvec3& point) const;
  // Near any point within the bounds of a triangle that was added?
  bool several(const scene::Bounds& triangle) const;

private:
  static constexpr int cells = 128; // along each axis
  // Cells written, above which the grid gives up and says `several` everywhere: a second's work.
  static constexpr long most_work = 1L << 28;
  static constexpr std::uint32_t nobody = ~0u, many = ~0u - 1;

  glm::ivec3 cell_of(const glm::dvec3& point) const;
  static std::size_t index(const glm::ivec3& cell) {
    return static_cast<std::size_t>((cell.z * cells + cell.y) * cells + cell.x);
  }

  glm::dvec3 low_, scale_;
  long work_ = 0;
  std::vector<std::uint32_t> owners_; // while triangles are added
  std::vector<bool> several_;         // 256 KiB, which a processor's cache holds
};

} // namespace gg::truth
