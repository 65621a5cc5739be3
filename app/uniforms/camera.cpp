#include "uniforms/camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gg::uniforms {
namespace {

// The digits of i mirrored at the point: in [0, 1).
double radical_inverse(int i, int base) {
  double inverse = 0.0;
  for (double place = 1.0 / base; i > 0; i /= base, place /= base)
    inverse += place * (i % base);
  return inverse;
}

// The parts of a Gaussian that share its area: its own radii at even steps of its integral, each
// turned from the one before by the golden angle (Vogel's spiral), so that no direction is favoured.
std::vector<glm::dvec2> spiral(int count) {
  std::vector<glm::dvec2> points;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double radius = std::sqrt(-2.0 * std::log1p(-(i + 0.5) / count));
    points.push_back(radius * glm::dvec2(std::cos(golden * i), std::sin(golden * i)));
  }
  return points;
}

// Moved, stretched and sheared by as little as gives them the mean 0 and the covariance `variance`
// times the identity (Cholesky).
void whiten(std::vector<glm::dvec2>& points, double variance) {
  glm::dvec2 mean(0.0);
  for (const glm::dvec2& p : points)
    mean += p / static_cast<double>(points.size());
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (glm::dvec2& p : points) {
    p -= mean;
    xx += p.x * p.x / static_cast<double>(points.size());
    xy += p.x * p.y / static_cast<double>(points.size());
    yy += p.y * p.y / static_cast<double>(points.size());
  }
  const double lean = xy / xx, height = std::sqrt(yy - xy * lean);
  for (glm::dvec2& p : points)
    p = std::sqrt(variance) * glm::dvec2(p.x / std::sqrt(xx), (p.y - lean * p.x) / height);
}

} // namespace

glm::dmat4 clip_from_view(const scene::Camera& camera, double aspect) {
  glm::dmat4 m(0.0);
  const double near = camera.near, far = camera.far;
  if (camera.orthographic) {
    // The vertical extent is kept, the horizontal one follows the picture's shape.
    m[0][0] = 1.0 / (camera.magnification.y * aspect);
    m[1][1] = 1.0 / camera.magnification.y;
    m[2][2] = 1.0 / (far - near);
    m[3][2] = far / (far - near);
    m[3][3] = 1.0;
    return m;
  }
  const double cot = 1.0 / std::tan(0.5 * static_cast<double>(camera.fovy));
  m[0][0] = cot / aspect;
  m[1][1] = cot;
  m[2][3] = -1.0;
  if (far > near) {
    m[2][2] = near / (far - near);
    m[3][2] = near * far / (far - near);
  } else {
    m[3][2] = near;
  }
  return m;
}

glm::dmat4 view_from_world(const scene::Camera& camera) {
  return glm::inverse(glm::dmat4(camera.world));
}

glm::dmat4 offset_by_pixels(double x, double y, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(-2.0 * x / width, 2.0 * y / height, 0.0));
}

glm::dvec2 sample_position(int i, int count) {
  if (count <= 1) return {0.0, 0.0};
  // For count a power of two the radical inverses are k / count, so half a step centres them; for
  // others the mean is within 1 / (2 count) of it.
  return {(i + 0.5) / count - 0.5, radical_inverse(i, 2) + 0.5 / count - 0.5};
}

glm::dvec3 lobe_stratum(int i, int count) {
  if (count < 3) return {0.0, 0.0, 1.0};
  // Half of the variance stays in each part's own lookup: a lamp then shows no beads, one for each part, at 4 samples or at 32, and
  // the pyramid's levels, whose tail is nearer to a lobe's than a Gaussian's, keep theirs (rough slabs of one lobe: relMSE .009
  // where all is kept, .014 with a half, .018 with a quarter; balls gain by a third with a half, by two fifths with a quarter).
  const double kept = 0.5;
  std::vector<glm::dvec2> points = spiral(count);
  whiten(points, 1.0 - kept);
  // Neighbours on the spiral must not be neighbours in the pixel: in the order of a base that the
  // positions there do not use.
  const double own = radical_inverse(i, 3);
  int place = 0;
  for (int k = 0; k < count; ++k)
    place += radical_inverse(k, 3) < own ? 1 : 0;
  const glm::dvec2& at = points[static_cast<std::size_t>(place)];
  return {at.x, at.y, std::sqrt(kept)};
}

} // namespace gg::uniforms
