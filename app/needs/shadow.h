// The mean shadow of points' convex hull, and how long they stretch.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace gg::needs {

// So many points tell a hull's area within a hundredth (a sphere's: .4 %).
inline constexpr std::size_t most_shadow_points = 2048;

struct MeanShadow {
  double area = 0.0; // m²: over all directions of light; a quarter of the hull's area [Cauchy 1841]
  glm::dvec3 centre{0.0}; // nearest to all shadows' centroids
};
// Over directions spread evenly. No area, and the points' mean: fewer than three, or none that span one.
MeanShadow mean_shadow(const std::vector<glm::dvec3>& points);

struct LongestAxis {
  glm::dvec3 direction{1.0, 0.0, 0.0}; // unit: of the greatest variance
  double length = 0.0, width = 0.0;    // metres: extents along it, and the greater of two across it
};
LongestAxis longest_axis(const std::vector<glm::dvec3>& points);

} // namespace gg::needs
