#include "needs/shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::needs {
namespace {

constexpr int shadow_directions = 21; // of half a sphere: a box's mean within a hundredth
constexpr int power_steps = 32;       // of the power method: enough where one axis is twice another

struct Shadow {
  double area = 0.0;
  glm::dvec2 centre{0.0};
};

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The convex hull by Andrew's monotone chain, and its area and centroid.
Shadow shadow_of(std::vector<glm::dvec2> points) {
  std::ranges::sort(points, [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  std::vector<glm::dvec2> hull(2 * points.size());
  std::size_t n = 0;
  const auto add = [&](const glm::dvec2& p, std::size_t least) {
    while (n >= least && turn(hull[n - 2], hull[n - 1], p) <= 0.0)
      --n;
    hull[n++] = p;
  };
  for (const glm::dvec2& p : points)
    add(p, 2);
  const std::size_t lower = n + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;)
    add(points[i], lower);
  Shadow shadow;
  for (std::size_t i = 1; i + 2 < n; ++i) {
    const double twice = turn(hull[0], hull[i], hull[i + 1]);
    shadow.area += 0.5 * twice;
    shadow.centre += 0.5 * twice / 3.0 * (hull[0] + hull[i] + hull[i + 1]);
  }
  if (shadow.area > 0.0) shadow.centre /= shadow.area;
  return shadow;
}

glm::dvec3 mean_of(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& p : points)
    sum += p;
  return points.empty() ? sum : sum / static_cast<double>(points.size());
}

} // namespace

MeanShadow mean_shadow(const std::vector<glm::dvec3>& points) {
  MeanShadow mean;
  mean.centre = mean_of(points);
  if (points.size() < 3) return mean;
  glm::dmat3 across(0.0);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < shadow_directions; ++i) {
    // A spiral of the golden angle over half of the sphere: shadows from both ends of a direction are alike.
    const double z = (i + 0.5) / shadow_directions;
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0)), r = std::sqrt(1.0 - z * z);
    const glm::dvec3 d(r * std::cos(angle), r * std::sin(angle), z);
    const glm::dvec3 u = glm::normalize(
        glm::cross(std::abs(d.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), d));
    const glm::dvec3 v = glm::cross(d, u);
    std::vector<glm::dvec2> flat;
    flat.reserve(points.size());
    for (const glm::dvec3& p : points)
      flat.emplace_back(glm::dot(p - mean.centre, u), glm::dot(p - mean.centre, v));
    const Shadow shadow = shadow_of(std::move(flat));
    mean.area += shadow.area / shadow_directions;
    // The point nearest to the lines through the shadows' centroids, each weighted by its area.
    across += shadow.area * (glm::dmat3(1.0) - glm::outerProduct(d, d));
    sum += shadow.area * (shadow.centre.x * u + shadow.centre.y * v);
  }
  if (mean.area > 0.0 && std::abs(glm::determinant(across)) > 0.0)
    mean.centre += glm::inverse(across) * sum;
  return mean;
}

LongestAxis longest_axis(const std::vector<glm::dvec3>& points) {
  LongestAxis axis;
  if (points.empty()) return axis;
  const glm::dvec3 centre = mean_of(points);
  glm::dmat3 spread(0.0);
  for (const glm::dvec3& p : points)
    spread += glm::outerProduct(p - centre, p - centre);
  glm::dvec3 d(1.0, 0.9, 0.8); // on no axis of symmetry
  for (int i = 0; i < power_steps; ++i) {
    const glm::dvec3 next = spread * d;
    if (!(glm::dot(next, next) > 0.0)) return axis;
    d = glm::normalize(next);
  }
  axis.direction = d;
  const glm::dvec3 u = glm::normalize(
      glm::cross(std::abs(d.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), d));
  const auto extent = [&](const glm::dvec3& along) {
    double low = 0.0, high = 0.0;
    for (const glm::dvec3& p : points) {
      low = std::min(low, glm::dot(p - centre, along));
      high = std::max(high, glm::dot(p - centre, along));
    }
    return high - low;
  };
  axis.length = extent(d);
  axis.width = std::max(extent(u), extent(glm::cross(d, u)));
  return axis;
}

} // namespace gg::needs
