#include "truth/neighbourhoods.h"

#include <algorithm>

namespace gg::truth {

Neighbourhoods::Neighbourhoods(const scene::Bounds& bounds)
    : low_(bounds.low), owners_(static_cast<std::size_t>(cells) * cells * cells, nobody) {
  const glm::dvec3 size = glm::dvec3(bounds.high) - low_;
  for (int c = 0; c < 3; ++c)
    scale_[c] = size[c] > 0.0 ? cells / size[c] : 0.0;
}

glm::ivec3 Neighbourhoods::cell_of(const glm::dvec3& point) const {
  const glm::dvec3 at = (point - low_) * scale_;
  glm::ivec3 cell(0);
  for (int c = 0; c < 3; ++c)
    if (at[c] >= 0.0) cell[c] = static_cast<int>(std::min(at[c], cells - 1.0)); // not if NaN
  return cell;
}

void Neighbourhoods::add(std::uint32_t part, const scene::Bounds& triangle) {
  const glm::ivec3 first = cell_of(triangle.low), last = cell_of(triangle.high);
  const glm::ivec3 count = last - first + 1;
  work_ += static_cast<long>(count.x) * count.y * count.z;
  if (work_ > most_work) return;
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        std::uint32_t& owner = owners_[index({x, y, z})];
        if (owner != part) owner = owner == nobody ? part : many;
      }
}

void Neighbourhoods::close() {
  several_.resize(owners_.size());
  for (std::size_t i = 0; i < owners_.size(); ++i)
    several_[i] = owners_[i] == many;
  owners_ = {};
}

bool Neighbourhoods::several(const glm::dvec3& point) const {
  return work_ > most_work || several_[index(cell_of(point))];
}

bool Neighbourhoods::several(const scene::Bounds& triangle) const {
  if (work_ > most_work) return true;
  const glm::ivec3 first = cell_of(triangle.low), last = cell_of(triangle.high);
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x)
        if (several_[index({x, y, z})]) return true;
  return false;
}

} // namespace gg::truth
