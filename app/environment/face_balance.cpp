#include "environment/face_balance.h"

#include "glsl/f64.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gg::environment {
namespace {

namespace glsl = gg::glsl::f64;

// The texels of a face up to what mirrors the cube onto itself: one triangle of eight.
class Triangle {
public:
  explicit Triangle(int size) : size_(size) {}
  int side() const { return size_ / 2; }
  std::size_t count() const { return index(side() - 1, side() - 1) + 1; }
  // Of the texel of the triangle that (x, y) is an image of.
  std::size_t index(int x, int y) const {
    x = std::min(x, size_ - 1 - x);
    y = std::min(y, size_ - 1 - y);
    if (x > y) std::swap(x, y);
    return static_cast<std::size_t>(y * (y + 1) / 2 + x);
  }
  // Calls with each texel x <= y of the triangle, in the order of the indices.
  template <class Use>
  void each(const Use& use) const {
    for (int y = 0; y < side(); ++y)
      for (int x = 0; x <= y; ++x)
        use(x, y);
  }
  std::vector<double> areas() const {
    std::vector<double> areas;
    each([&](int x, int y) { areas.push_back(glsl::cubeTexelSolidAngle(x, y, size_)); });
    return areas;
  }
  // Of a value per texel of the triangle, the whole face.
  std::vector<float> face(const std::vector<double>& values) const {
    std::vector<float> all;
    for (int y = 0; y < size_; ++y)
      for (int x = 0; x < size_; ++x)
        all.push_back(static_cast<float>(values[index(x, y)]));
    return all;
  }

private:
  int size_;
};

// The kernel between a texel and another, or an image of it.
struct Reading {
  std::uint32_t texel;
  double kernel;
};

// What environment_blur.comp sums up for the texel (x, y).
void read_around(int x, int y, int size, const Triangle& triangle, const glm::dvec4& kernel,
                 std::vector<Reading>& readings) {
  const double radius = kernel.x, limit = kernel.y, cos_radius = std::cos(radius),
               sin_radius = std::sin(radius);
  const glm::dvec3 direction = glsl::cubeTexelDirection(0, x, y, size);
  const auto added_at = [&](double z) { return kernel.w * z * z * z; };
  const double own_z = glsl::cubeLocal(0, direction).z;
  const double inverse = kernel.z / (1.0 - added_at(own_z));
  for (int face = 0; face < 6; ++face) {
    const glm::dvec3 local = glsl::cubeLocal(face, direction);
    const auto range = glsl::cubeCapFace(local, cos_radius, sin_radius, size);
    for (int v = range.firstY; v <= range.lastY; ++v) {
      const double t = glsl::cubeCoordinate(v, size);
      const auto part = glsl::cubeCapRow(local, cos_radius, t, size);
      for (int u = std::max(part.x, range.firstX); u <= std::min(part.y, range.lastX); ++u) {
        const double s = glsl::cubeCoordinate(u, size), z = 1.0 / std::sqrt(1.0 + s * s + t * t);
        const glm::dvec3 apart = local - glm::dvec3(s * z, t * z, z);
        const double chord2 = apart.x * apart.x + apart.y * apart.y + apart.z * apart.z;
        if (chord2 > limit) continue;
        const double added = added_at(z);
        readings.push_back({static_cast<std::uint32_t>(triangle.index(u, v)),
                            glsl::heatKernel(chord2, inverse * (1.0 + added + added * added))});
      }
    }
  }
}

} // namespace

std::vector<float> blur_weights(int size, const glm::vec4& kernel) {
  // The kernel being symmetric, one factor b per texel mends rows and columns both: b(d) sum of k(d, s) b(s) area(s) = 1
  // [Knight08, symmetric balancing]. Steps of b = sqrt(b / sum) starting from 1 find it; what is left after six is
  // below 1e-4. Kept is area times b.
  constexpr int steps = 6;
  const Triangle triangle(size);
  const std::vector<double> areas = triangle.areas();
  std::vector<Reading> readings;
  std::vector<std::size_t> ends;
  triangle.each([&](int x, int y) {
    read_around(x, y, size, triangle, glm::dvec4(kernel), readings);
    ends.push_back(readings.size());
  });
  std::vector<double> weights = areas;
  for (int step = 0; step < steps; ++step) {
    std::vector<double> next;
    std::size_t at = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      double total = 0.0;
      for (; at < ends[i]; ++at)
        total += readings[at].kernel * weights[readings[at].texel];
      next.push_back(std::sqrt(areas[i] * weights[i] / total));
    }
    weights = std::move(next);
  }
  return triangle.face(weights);
}

std::vector<float> zonal_weights(int size, int source_size, std::span<const float> kernel) {
  // On the lattice of the results and on that of the source in turn, a texel's weight is its area over what it gets, the sum of
  // kernel times weight [SinkhornKnopp67]. What is left after eight rounds is below 1e-4.
  constexpr int rounds = 8;
  const Triangle results(size), sources(source_size);
  const std::vector<double> result_areas = results.areas(), source_areas = sources.areas();
  // Row by row of the results: the kernel to a texel of the source, summed over its images. And over the images of both, which
  // is what columns need: a texel beside the diagonal has twice those of one on it.
  std::vector<double> to_result, to_all;
  results.each([&](int x, int y) {
    std::vector<double> row(sources.count(), 0.0);
    const glm::dvec3 direction = glsl::cubeTexelDirection(0, x, y, size);
    for (int face = 0; face < 6; ++face)
      for (int v = 0; v < source_size; ++v)
        for (int u = 0; u < source_size; ++u) {
          const glm::dvec3 apart = direction - glsl::cubeTexelDirection(face, u, v, source_size);
          const double half_chord =
              0.5 * std::sqrt(apart.x * apart.x + apart.y * apart.y + apart.z * apart.z);
          const auto last = static_cast<double>(kernel.size() - 1);
          const auto place = static_cast<std::size_t>(std::min(half_chord * last + 0.5, last));
          row[sources.index(u, v)] += static_cast<double>(kernel[place]);
        }
    for (const double sum : row) {
      to_result.push_back(sum);
      to_all.push_back((x == y ? 1.0 : 2.0) * sum);
    }
  });
  std::vector<double> weights = source_areas;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> given(sources.count(), 0.0);
    for (std::size_t i = 0; i < results.count(); ++i) {
      const std::size_t row = i * sources.count();
      double total = 0.0;
      for (std::size_t j = 0; j < sources.count(); ++j)
        total += to_result[row + j] * weights[j];
      for (std::size_t j = 0; j < sources.count(); ++j)
        given[j] += to_all[row + j] * result_areas[i] / total;
    }
    std::size_t j = 0;
    sources.each([&](int x, int y) {
      weights[j] = source_areas[j] * (x == y ? 1.0 : 2.0) / given[j];
      ++j;
    });
  }
  return sources.face(weights);
}

} // namespace gg::environment
