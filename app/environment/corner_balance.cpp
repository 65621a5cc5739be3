#include "environment/corner_balance.h"

#include "environment/map.h"
#include "glsl/f64.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::environment {
namespace {

namespace glsl = gg::glsl::f64;

struct Point {
  glm::dvec3 direction;
  double weight;     // solid angle of a texel, weight of a pixel
  std::size_t index; // of a pixel
  bool inner;        // a pixel that is balanced
};

std::vector<Point> pixels_around(const glm::dvec3& centre, double radius, double inner, int width,
                                 int height, const std::vector<float>& row_weights) {
  std::vector<Point> points;
  const double step = std::numbers::pi / height;
  const double theta = std::acos(centre.y);
  for (int y = std::max(0, static_cast<int>((theta - radius) / step));
       y < height && y * step < theta + radius; ++y)
    for (int x = 0; x < width; ++x) {
      const double phi = 2.0 * std::numbers::pi * ((x + 0.5) / width - 0.5), t = (y + 0.5) * step;
      const glm::dvec3 d(std::sin(t) * std::cos(phi), std::cos(t), std::sin(t) * std::sin(phi));
      const double apart = glm::distance(d, centre);
      if (apart < radius)
        points.push_back({d, static_cast<double>(row_weights[static_cast<std::size_t>(y)]),
                          static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                              + static_cast<std::size_t>(x),
                          apart < inner});
    }
  return points;
}

std::vector<Point> texels_around(const glm::dvec3& centre, double radius, int face_size) {
  std::vector<Point> points;
  for (int face = 0; face < 6; ++face) {
    const auto range = glsl::cubeCapFace(glsl::cubeLocal(face, centre), std::cos(radius),
                                         std::sin(radius), face_size);
    for (int y = range.firstY; y <= range.lastY; ++y)
      for (int x = range.firstX; x <= range.lastX; ++x)
        points.push_back({glsl::cubeTexelDirection(face, x, y, face_size),
                          glsl::cubeTexelSolidAngle(x, y, face_size), 0, false});
  }
  return points;
}

struct Reading {
  std::size_t texel, pixel;
  double kernel;
};

void balance(const glm::dvec3& corner, int width, int height, int face, double sigma, double reach,
             const std::vector<float>& row_weights, std::vector<PixelFactor>& result) {
  constexpr int rounds = 30;
  const double radius = reach * sigma, inner = 2.5 * radius;
  const std::vector<Point> pixels =
      pixels_around(corner, inner + 2.0 * radius, inner, width, height, row_weights);
  const std::vector<Point> texels = texels_around(corner, inner + radius, face);
  const double limit = 2.0 * std::sin(0.5 * radius);
  std::vector<Reading> readings;
  for (std::size_t t = 0; t < texels.size(); ++t)
    for (std::size_t p = 0; p < pixels.size(); ++p) {
      const glm::dvec3 apart = texels[t].direction - pixels[p].direction;
      const double chord2 = glm::dot(apart, apart);
      if (chord2 <= limit * limit)
        readings.push_back({t, p, std::exp(-0.5 * chord2 / (sigma * sigma))});
    }
  std::vector<double> factor(pixels.size(), 1.0);
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> total(texels.size(), 0.0), given(pixels.size(), 0.0);
    for (const Reading& r : readings)
      total[r.texel] += r.kernel * pixels[r.pixel].weight * factor[r.pixel];
    for (const Reading& r : readings)
      if (pixels[r.pixel].inner)
        given[r.pixel] += texels[r.texel].weight * r.kernel * factor[r.pixel] / total[r.texel];
    // given is relative to the pixel's weight, which away from the poles is its solid angle.
    for (std::size_t p = 0; p < pixels.size(); ++p)
      if (pixels[p].inner && given[p] > 0.0) factor[p] /= given[p];
  }
  for (std::size_t p = 0; p < pixels.size(); ++p)
    if (pixels[p].inner) result.push_back({pixels[p].index, static_cast<float>(factor[p])});
}

} // namespace

std::vector<PixelFactor> balanced_corners(int width, int height, int face, double sigma,
                                          double reach, const std::vector<float>& row_weights) {
  std::vector<PixelFactor> factors;
  // Where a kernel spans half the way between two corners, their neighbourhoods would overlap.
  if (4.5 * reach * sigma > 0.5) return factors;
  std::vector<PixelFactor> one;
  balance(glm::normalize(glm::dvec3(1.0)), width, height, face, sigma, reach, row_weights, one);
  // Both lattices are their own mirror images in x, y and z: the other seven corners are like this one.
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  for (const PixelFactor& f : one) {
    const std::size_t x = f.pixel % w, y = f.pixel / w;
    for (const std::size_t row : {y, h - 1 - y})
      for (const std::size_t column : {x, w - 1 - x, (w + w / 2 - 1 - x) % w, (w / 2 + x) % w})
        factors.push_back({row * w + column, f.factor});
  }
  return factors;
}

} // namespace gg::environment
