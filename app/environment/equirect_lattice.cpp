#include "environment/equirect_lattice.h"

#include "environment/corner_balance.h"
#include "environment/zonal.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace gg::environment {
namespace {

std::vector<float> rows_of(const Map& map, const std::vector<float>& balanced) {
  std::vector<float> rows(static_cast<std::size_t>(3 * 4 * map.width));
  const auto put = [&](int row, int at, double a, double b, float c) {
    const auto place = 4 * static_cast<std::size_t>(row * map.width + at);
    rows[place] = static_cast<float>(a);
    rows[place + 1] = static_cast<float>(b);
    rows[place + 2] = c;
  };
  for (int y = 0; y < map.height; ++y) {
    const double theta = std::numbers::pi * (y + 0.5) / map.height;
    put(0, y, std::sin(theta), std::cos(theta), balanced[static_cast<std::size_t>(y)]);
  }
  const double column = 2.0 * std::numbers::pi / map.width;
  for (int x = 0; x < map.width; ++x) {
    const double phi = (x + 0.5) * column - std::numbers::pi;
    put(1, x, std::cos(phi), std::sin(phi), 0.0f);
  }
  put(2, 0, std::cos(column), std::sin(column), 0.0f);
  return rows;
}

} // namespace

EquirectLattice equirect_lattice(const Map& map, int face, float unit, double sigma, double reach) {
  EquirectLattice lattice;
  const std::size_t pixels = map.rgb.size() / 3;
  lattice.texels.resize(4 * pixels);
  const float scale = 1.0f / unit;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      lattice.texels[4 * i + c] = scale * map.rgb[3 * i + c];
    lattice.texels[4 * i + 3] = 1.0f;
  }
  const std::vector<float> balanced = balanced_rows(map.width, map.height, sigma, reach);
  for (const PixelFactor& f : balanced_corners(map.width, map.height, face, sigma, reach, balanced))
    lattice.texels[4 * f.pixel + 3] = f.factor;
  lattice.rows = rows_of(map, balanced);
  return lattice;
}

} // namespace gg::environment
