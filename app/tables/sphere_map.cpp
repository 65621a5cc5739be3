#include "tables/sphere_map.h"

#include "glsl/f32.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gg::tables {
namespace {

using namespace gg::glsl;

// Kernels end at this many sigma; what is cut off (0.4 % of the volume) is made up for in the width, below.
constexpr double kernel_reach = 3.3;

// Variance of a two-dimensional Gaussian cut off at `reach` sigma, relative to the whole one's.
double cut_variance(double reach) {
  const double edge = 0.5 * reach * reach;
  return 1.0 - edge * std::exp(-edge) / (1.0 - std::exp(-edge));
}

template <typename F>
void for_each_texel(int size, F&& f) {
  tbb::parallel_for(0, 6 * size, [&](int row) {
    for (int x = 0; x < size; ++x)
      f(row / size, x, row % size);
  });
}

int face_of(const glm::vec3& d) {
  const glm::vec3 a(std::abs(d.x), std::abs(d.y), std::abs(d.z));
  if (a.x >= a.y && a.x >= a.z) return d.x > 0.0f ? 0 : 1;
  if (a.y >= a.z) return d.y > 0.0f ? 2 : 3;
  return d.z > 0.0f ? 4 : 5;
}

} // namespace

float SphereMap::radiance(const glm::vec3& direction) const {
  const int face = face_of(direction);
  const glm::vec3 l = f32::cubeLocal(face, direction);
  const float n = static_cast<float>(size);
  const float x = std::clamp(0.5f * (l.x / l.z + 1.0f) * n - 0.5f, 0.0f, n - 1.0f);
  const float y = std::clamp(0.5f * (l.y / l.z + 1.0f) * n - 0.5f, 0.0f, n - 1.0f);
  const int x0 = std::min(static_cast<int>(x), std::max(size - 2, 0)),
            x1 = std::min(x0 + 1, size - 1);
  const int y0 = std::min(static_cast<int>(y), std::max(size - 2, 0)),
            y1 = std::min(y0 + 1, size - 1);
  const float u = x - static_cast<float>(x0), v = y - static_cast<float>(y0);
  return (1 - v) * ((1 - u) * at(face, x0, y0) + u * at(face, x1, y0))
         + v * ((1 - u) * at(face, x0, y1) + u * at(face, x1, y1));
}

SphereMap sample_sphere(int size, const std::function<float(const glm::vec3&)>& radiance) {
  constexpr int grid = 2;
  SphereMap map(size);
  for_each_texel(size, [&](int face, int x, int y) {
    double sum = 0.0;
    for (int k = 0; k < grid * grid; ++k)
      sum += radiance(
          f32::cubeTexelDirection(face, grid * x + k % grid, grid * y + k / grid, grid * size));
    map.at(face, x, y) = static_cast<float>(sum / (grid * grid));
  });
  return map;
}

SphereMap halved(const SphereMap& map) {
  SphereMap half(map.size / 2);
  for_each_texel(half.size, [&](int face, int x, int y) {
    float sum = 0.0f, total = 0.0f;
    for (int k = 0; k < 4; ++k) {
      const int sx = 2 * x + k % 2, sy = 2 * y + k / 2;
      const float weight = f32::cubeTexelSolidAngle(sx, sy, map.size);
      sum += weight * map.at(face, sx, sy);
      total += weight;
    }
    half.at(face, x, y) = sum / total;
  });
  return half;
}

std::vector<SphereMap> blurred(const std::vector<SphereMap>& maps, double variance) {
  const double width = variance / cut_variance(kernel_reach);
  const double radius = std::min(kernel_reach * std::sqrt(width), 1.5);
  const auto cos_radius = static_cast<float>(std::cos(radius)),
             sin_radius = static_cast<float>(std::sin(radius));
  const auto limit = static_cast<float>(2.0 - 2.0 * std::cos(radius)); // chord²
  const auto inverse = static_cast<float>(0.5 / width);
  const int n = maps.front().size;
  const std::size_t count = maps.size(), texels = maps.front().texels.size();
  // Of a texel: its direction and solid angle, and the maps' values side by side.
  std::vector<glm::vec4> lattice(texels);
  std::vector<float> values(texels * count);
  for_each_texel(n, [&](int face, int x, int y) {
    const auto texel = static_cast<std::size_t>((face * n + y) * n + x);
    lattice[texel] =
        glm::vec4(f32::cubeTexelDirection(face, x, y, n), f32::cubeTexelSolidAngle(x, y, n));
    for (std::size_t m = 0; m < count; ++m)
      values[texel * count + m] = maps[m].texels[texel];
  });
  std::vector<SphereMap> result(count, SphereMap(n));
  tbb::parallel_for(0, 6 * n, [&](int row) {
    std::vector<float> sums(count);
    for (int x = 0; x < n; ++x) {
      const auto here = static_cast<std::size_t>(row * n + x);
      const glm::vec3 d(lattice[here]);
      float total = 0.0f;
      std::fill(sums.begin(), sums.end(), 0.0f);
      for (int source = 0; source < 6; ++source) {
        const auto range = f32::cubeCapFace(f32::cubeLocal(source, d), cos_radius, sin_radius, n);
        for (int j = range.firstY; j <= range.lastY; ++j)
          for (int i = range.firstX; i <= range.lastX; ++i) {
            const auto texel = static_cast<std::size_t>((source * n + j) * n + i);
            const glm::vec3 apart = d - glm::vec3(lattice[texel]);
            const float chord2 = glm::dot(apart, apart);
            if (chord2 > limit) continue;
            // The heat kernel's first term, with theta² = c + c²/12 + c³/90 and sqrt(theta / sin theta).
            const float theta2 = chord2 * (1.0f + chord2 * (1.0f / 12.0f + chord2 / 90.0f));
            const float weight =
                std::exp(-theta2 * inverse) * (1.0f + theta2 / 12.0f) * lattice[texel].w;
            const float* value = &values[texel * count];
            for (std::size_t m = 0; m < count; ++m)
              sums[m] += weight * value[m];
            total += weight;
          }
      }
      for (std::size_t m = 0; m < count; ++m)
        result[m].texels[here] = sums[m] / total;
    }
  });
  return result;
}

double SphereStack::first_sigma(int size) {
  return 2.5 / size;
}

SphereStack::SphereStack(SphereMap map) {
  double log_sum = 0.0, area = 0.0;
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < map.size; ++y)
      for (int x = 0; x < map.size; ++x) {
        const double weight = f32::cubeTexelSolidAngle(x, y, map.size);
        // A black texel has no logarithm: a millionth of the maps' unit of radiance.
        log_sum += weight * std::log(std::max(map.at(face, x, y), 1e-6f));
        area += weight;
      }
  geometric_mean = std::exp(log_sum / area);
  levels_.push_back(std::move(map));
  sigmas_.push_back(0.0);
}

std::vector<SphereStack> stacks_of(const std::vector<SphereMap>& maps) {
  std::vector<SphereStack> stacks;
  for (const SphereMap& map : maps)
    stacks.push_back(SphereStack(map));
  if (maps.empty()) return stacks;
  double variance = 0.0;
  std::vector<SphereMap> working = maps;
  for (double sigma = SphereStack::first_sigma(working.front().size); sigma < 1.35;
       sigma *= std::sqrt(2.0)) {
    // Halving adds a quarter of a texel's area per axis; the sphere's mean will do here.
    const int size = working.front().size, levels = stacks.front().level_count();
    if (levels % 2 == 1 && levels > 1 && size > 32) {
      variance += 4.0 * 3.14159265358979 / (6.0 * size * size) / 4.0;
      for (SphereMap& map : working)
        map = halved(map);
    }
    working = blurred(working, sigma * sigma - variance);
    variance = sigma * sigma;
    for (std::size_t m = 0; m < working.size(); ++m) {
      stacks[m].levels_.push_back(working[m]);
      stacks[m].sigmas_.push_back(sigma);
    }
  }
  return stacks;
}

int SphereStack::nearest_level(double sigma) const {
  if (sigma <= 0.0) return 0;
  const double step = 2.0 * std::log2(sigma / sigmas_[1]);
  return std::clamp(static_cast<int>(std::lround(1.0 + step)), 0, level_count() - 1);
}

float SphereStack::radiance_nearest(const glm::vec3& direction, double sigma) const {
  return levels_[static_cast<std::size_t>(nearest_level(sigma))].radiance(direction);
}

float SphereStack::radiance(const glm::vec3& direction, double sigma) const {
  const double limited = std::clamp(sigma, 0.0, sigmas_.back());
  int low = limited < sigmas_[1]
                ? 0
                : static_cast<int>(1.0 + std::floor(2.0 * std::log2(limited / sigmas_[1])));
  low = std::clamp(low, 0, level_count() - 2);
  const double a = sigmas_[static_cast<std::size_t>(low)],
               b = sigmas_[static_cast<std::size_t>(low) + 1];
  const auto weight = static_cast<float>((limited * limited - a * a) / (b * b - a * a));
  return (1.0f - weight) * level(low).radiance(direction)
         + weight * level(low + 1).radiance(direction);
}

} // namespace gg::tables
