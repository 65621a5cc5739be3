// Which texels a cap may touch: shaders/environment/cube.glsl, against all texels of a face.
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gg::environment {
namespace {

namespace f32 = gg::glsl::f32;
namespace f64 = gg::glsl::f64;

constexpr int size = 48;

struct Cap {
  glm::dvec3 centre; // in the frame of the face
  double radius;
};

bool holds(const Cap& cap, int x, int y) {
  return glm::dot(cap.centre, f64::cubeTexel(x, y, size).local) >= std::cos(cap.radius);
}

// Caps of all sizes that are used about directions all around, axes and edges of the cube among them, where formulas divide by 0.
std::vector<Cap> caps() {
  std::vector<Cap> list;
  const double radii[] = {0.01, 0.04, 0.2, 0.6};
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        for (double radius : radii)
          if (x || y || z) list.push_back({glm::normalize(glm::dvec3(x, y, z)), radius});
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i)
    list.push_back(
        {glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))), radii[i % 4]});
  return list;
}

TEST(cube_caps, hold_every_texel_within_reach) {
  for (const Cap& cap : caps()) {
    // As the shaders ask: the sine from above, the cosine from below, and a cap with 1e-5 to spare for float32.
    const double radius = cap.radius + 1e-5;
    const glm::vec3 centre(cap.centre);
    const float cosine = static_cast<float>(1.0 - 0.5 * radius * radius);
    const auto range = f32::cubeCapFace(centre, cosine, static_cast<float>(radius), size);
    for (int y = 0; y < size; ++y) {
      const auto row = f32::cubeCapRow(centre, cosine, f32::cubeCoordinate(y, size), size);
      for (int x = 0; x < size; ++x) {
        if (!holds(cap, x, y)) continue;
        ASSERT_TRUE(x >= range.firstX && x <= range.lastX && y >= range.firstY && y <= range.lastY)
            << cap.radius << " at " << cap.centre.x << ' ' << cap.centre.y << ' ' << cap.centre.z;
        ASSERT_TRUE(x >= row.x && x <= row.y)
            << cap.radius << " at " << cap.centre.x << ' ' << cap.centre.y << ' ' << cap.centre.z;
      }
    }
  }
}

TEST(cube_caps, are_not_read_as_larger_than_they_are) {
  for (const Cap& cap : caps()) {
    if (cap.radius > 0.5) continue; // may hold a pole of the rows, which are then read as a whole
    const auto range =
        f64::cubeCapFace(cap.centre, std::cos(cap.radius), std::sin(cap.radius), size);
    int held = 0, read = 0;
    for (int y = range.firstY; y <= range.lastY; ++y) {
      const auto row =
          f64::cubeCapRow(cap.centre, std::cos(cap.radius), f64::cubeCoordinate(y, size), size);
      for (int x = std::max(range.firstX, row.x); x <= std::min(range.lastX, row.y); ++x) {
        ++read;
        held += holds(cap, x, y);
      }
    }
    // Only what the rounding that is allowed for has let in, on the rim.
    EXPECT_LE(read - held, 4) << cap.radius << " at " << cap.centre.x << ' ' << cap.centre.y << ' '
                              << cap.centre.z;
  }
}

} // namespace
} // namespace gg::environment
