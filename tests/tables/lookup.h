// A table read as the device reads it: bilinear or trilinear between texel centres, clamped at the edges.
#pragma once

#include "core/files.h"
#include "glsl/f64.h"
#include "tables/reflection_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gg::tables {

inline const ReflectionTable& stored(const Model& model) {
  static std::array<ReflectionTable, models.size()> tables;
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].distribution == model.distribution && models[i].smith == model.smith) {
      if (tables[i].energy.empty()) tables[i] = read(home_directory() / "assets" / "tables", model);
      return tables[i];
    }
  throw std::logic_error("no such model");
}

// `size` texels per axis; coordinates in [0, 1] as textures take them.
template <std::size_t Axes>
std::array<double, 4> lookup(const std::vector<float>& texels, const std::array<int, Axes>& size,
                             const std::array<double, Axes>& coordinate) {
  std::array<double, 4> result{};
  for (unsigned corner = 0; corner < (1u << Axes); ++corner) {
    double weight = 1.0;
    std::size_t index = 0, stride = 1;
    for (std::size_t a = 0; a < Axes; ++a) {
      const double at = std::clamp(coordinate[a] * size[a] - 0.5, 0.0, size[a] - 1.0);
      const int low = std::min(static_cast<int>(at), size[a] - 1),
                high = std::min(low + 1, size[a] - 1);
      const double f = at - low;
      const bool up = (corner >> a) & 1u;
      weight *= up ? f : 1.0 - f;
      index += stride * static_cast<std::size_t>(up ? high : low);
      stride *= static_cast<std::size_t>(size[a]);
    }
    for (std::size_t c = 0; c < 4; ++c)
      result[c] += weight * static_cast<double>(texels[4 * index + c]);
  }
  return result;
}

inline glsl::f64::LobeEnergy energy_at(const Model& model, double cos_theta, double alpha) {
  namespace f64 = glsl::f64;
  const auto u = f64::energyCoordinate(cos_theta, alpha);
  const auto t =
      lookup<2>(stored(model).energy, {f64::ENERGY_TABLE_SIZE, f64::ENERGY_TABLE_SIZE}, {u.x, u.y});
  return f64::lobeEnergy(f64::vec4(t[0], t[1], t[2], t[3]));
}

// lean and sigma / alpha
inline std::array<double, 4> tap_at(const Model& model, double cos_theta, double alpha,
                                    double edge) {
  namespace f64 = glsl::f64;
  const auto u = f64::lobeCoordinate(cos_theta, alpha, edge);
  return lookup<3>(stored(model).lobe,
                   {f64::LOBE_TABLE_SIZE, f64::LOBE_TABLE_SIZE, f64::LOBE_TABLE_SLICES},
                   {u.x, u.y, u.z});
}

} // namespace gg::tables
