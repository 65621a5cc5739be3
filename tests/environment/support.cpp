#include "environment/support.h"

#include "support/devices.h"

#include <glm/gtc/packing.hpp>

#include <cmath>
#include <cstring>
#include <numbers>

namespace gg::environment {

gpu::Device& device() {
  return test::shared_device(gpu::Backend::opengl, gpu::Surface::automatic);
}

CubeLevel read(const gpu::Texture& cube, int level, float unit) {
  CubeLevel result;
  result.size = std::max(cube.desc.width >> level, 1);
  // Reading takes a shared owner; the test's stack keeps the texture alive.
  const gpu::TextureRef borrowed(const_cast<gpu::Texture*>(&cube), [](gpu::Texture*) {});
  for (int face = 0; face < 6; ++face) {
    const std::vector<std::byte> bytes = device().read(borrowed, level, face);
    std::vector<std::uint16_t> halves(bytes.size() / 2);
    std::memcpy(halves.data(), bytes.data(), bytes.size());
    for (std::size_t i = 0; i < halves.size(); i += 4)
      result.texels.emplace_back(glm::dvec3(glm::unpackHalf1x16(halves[i]),
                                            glm::unpackHalf1x16(halves[i + 1]),
                                            glm::unpackHalf1x16(halves[i + 2]))
                                 * static_cast<double>(unit));
  }
  return result;
}

glm::dvec3 texel_direction(int face, int x, int y, int size) {
  const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
  // Major axis, and what s and t point along: OpenGL 4.5, table 8.19.
  static const glm::dvec3 axis[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                    {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  static const glm::dvec3 right[] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0},
                                     {1, 0, 0},  {1, 0, 0}, {-1, 0, 0}};
  static const glm::dvec3 down[] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1},
                                    {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
  return glm::normalize(axis[face] + s * right[face] + t * down[face]);
}

double texel_solid_angle(int x, int y, int size) {
  const auto corner = [](double s, double t) {
    return std::atan2(s * t, std::sqrt(1.0 + s * s + t * t));
  };
  const double s0 = 2.0 * x / size - 1.0, s1 = s0 + 2.0 / size, t0 = 2.0 * y / size - 1.0,
               t1 = t0 + 2.0 / size;
  return corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0);
}

glm::dvec3 mean(const CubeLevel& level) {
  glm::dvec3 sum(0.0);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < level.size; ++y)
      for (int x = 0; x < level.size; ++x)
        sum += texel_solid_angle(x, y, level.size) * level.at(face, x, y);
  return sum / (4.0 * std::numbers::pi);
}

glm::dvec3 pixel_direction(int width, int height, int x, int y) {
  const double phi = 2.0 * std::numbers::pi * ((x + 0.5) / width - 0.5),
               theta = std::numbers::pi * (y + 0.5) / height;
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

Map picture_of(int width, const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  Map map{"test", width, width / 2, {}};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 value = radiance(pixel_direction(width, map.height, x, y));
      for (int c = 0; c < 3; ++c)
        map.rgb.push_back(static_cast<float>(value[c]));
    }
  return map;
}

glm::dvec3 convolved(const Map& map, const glm::dvec3& direction,
                     const std::function<double(double)>& kernel) {
  glm::dvec3 sum(0.0);
  double total = 0.0;
  for (int y = 0; y < map.height; ++y) {
    const double area = std::sin(std::numbers::pi * (y + 0.5) / map.height);
    for (int x = 0; x < map.width; ++x) {
      const double weight =
          area * kernel(glm::dot(direction, pixel_direction(map.width, map.height, x, y)));
      sum += weight * glm::dvec3(map.at(x, y));
      total += weight;
    }
  }
  return sum / total;
}

std::function<double(double)> heat_kernel(double sigma) {
  constexpr int samples =
      20000; // over the angle: linear interpolation is good to (0.00016 / sigma)² / 8
  std::vector<double> table;
  for (int i = 0; i <= samples; ++i) {
    const double x = std::cos(std::numbers::pi * i / samples);
    double before = 0.0, now = 1.0, sum = 0.0;
    for (int l = 0; l < 2000; ++l) {
      const double damp = std::exp(-0.5 * l * (l + 1.0) * sigma * sigma);
      if (damp < 1e-14) break;
      sum += (2 * l + 1) * damp * now;
      const double next = ((2 * l + 1) * x * now - l * before) / (l + 1);
      before = now;
      now = next;
    }
    table.push_back(std::max(sum, 0.0)); // below 0 only by rounding
  }
  return [table](double c) {
    const double at = std::acos(std::clamp(c, -1.0, 1.0)) / std::numbers::pi * samples;
    const auto i = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(samples - 1));
    const double f = at - static_cast<double>(i);
    return (1.0 - f) * table[i] + f * table[i + 1];
  };
}

} // namespace gg::environment
