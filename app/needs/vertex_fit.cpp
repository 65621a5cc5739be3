#include "needs/vertex_fit.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace gg::needs {
namespace {

// The normal equations are those of linear elements' mass matrix, whose eigenvalues, divided by its diagonal, lie in [1/2, 2]
// [Wathen 1987]: each step of conjugate gradients leaves a third of the error or less.
constexpr int steps = 8;
constexpr double at_corner = 2.0 / 3.0, beside = 1.0 / 6.0;

// The first vertex at the same point with the same normal.
std::vector<std::uint32_t> first_alike(const std::vector<glm::vec3>& points,
                                       const std::vector<glm::vec3>& normals) {
  const auto key = [&](std::uint32_t i) {
    return std::tuple(points[i].x, points[i].y, points[i].z, normals[i].x, normals[i].y,
                      normals[i].z, i);
  };
  std::vector<std::uint32_t> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, key);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && points[order[k]] == points[order[k - 1]]
                      && normals[order[k]] == normals[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

struct Element {
  std::array<std::uint32_t, 3> corner;
  double area;
};

using Values = std::vector<double>;

Values times_mass(const std::vector<Element>& elements, const Values& x) {
  Values y(x.size());
  for (const Element& e : elements) {
    const double sum = x[e.corner[0]] + x[e.corner[1]] + x[e.corner[2]];
    for (const std::uint32_t i : e.corner)
      y[i] += e.area / 12.0 * (sum + x[i]);
  }
  return y;
}

double dot(const Values& a, const Values& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

} // namespace

std::vector<float> fitted_at_vertices(const std::vector<glm::vec3>& points,
                                      const std::vector<glm::vec3>& normals,
                                      const scene::Indices& corners,
                                      const std::vector<std::array<float, 3>>& inside) {
  const std::vector<std::uint32_t> first = first_alike(points, normals);
  std::vector<Element> elements(inside.size());
  Values right(points.size()), diagonal(points.size()), x(points.size());
  for (std::size_t t = 0; t < inside.size(); ++t) {
    Element& e = elements[t];
    for (std::size_t k = 0; k < 3; ++k)
      e.corner[k] = first[corners[3 * t + k]];
    const glm::dvec3 a(points[e.corner[0]]), b(points[e.corner[1]]), c(points[e.corner[2]]);
    e.area = 0.5 * glm::length(glm::cross(b - a, c - a));
    const double sum = static_cast<double>(inside[t][0]) + static_cast<double>(inside[t][1])
                       + static_cast<double>(inside[t][2]);
    for (std::size_t k = 0; k < 3; ++k) {
      right[e.corner[k]] +=
          e.area / 3.0 * (beside * sum + (at_corner - beside) * static_cast<double>(inside[t][k]));
      diagonal[e.corner[k]] += e.area / 6.0;
    }
  }
  const auto scaled = [&](const Values& r) {
    Values z(r.size());
    for (std::size_t i = 0; i < r.size(); ++i)
      z[i] = diagonal[i] > 0.0 ? r[i] / diagonal[i] : 0.0;
    return z;
  };
  Values rest = right, z = scaled(rest), along = z;
  for (int step = 0; step < steps; ++step) {
    const double before = dot(rest, z);
    const Values image = times_mass(elements, along);
    const double length = dot(along, image);
    if (!(length > 0.0)) break;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += before / length * along[i];
      rest[i] -= before / length * image[i];
    }
    z = scaled(rest);
    const double turn = before > 0.0 ? dot(rest, z) / before : 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
      along[i] = z[i] + turn * along[i];
  }
  std::vector<float> values(points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(x[first[i]]);
  return values;
}

} // namespace gg::needs
