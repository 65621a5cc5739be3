// The tables of assets/tables read on the host as the device reads them.
#pragma once

#include "glsl/f64.h"
#include "tables/interface_table.h"
#include "tables/reflection_table.h"

#include <algorithm>
#include <array>
#include <vector>

namespace gg::tables {

// Bilinear or trilinear between texel centres, clamped at the edges. `size` texels per axis; coordinates in [0, 1] as
// textures take them.
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

// What fetchInterfaceEnergy and fetchInterfaceLobe of shaders/refraction/interface_table_fetch.glsl return. Files are read
// once, on the first call (any thread may make it); throws Error(input) as reading them does.
glsl::f64::InterfaceEnergy interface_energy_at(const Model& model, double cos_theta, double alpha,
                                               double eta);
glsl::f64::InterfaceLobe interface_lobe_at(const Model& model, int lobe, int lobes,
                                           double cos_theta, double alpha, double eta);

// What fetchLobeEnergy reads, and of fetchReflectionLobeOf the texel: lean, sigma / alpha, weight.
glsl::f64::LobeEnergy reflection_energy_at(const Model& model, double cos_theta, double alpha);
std::array<double, 4> reflection_texel_at(const Model& model, int lobe, int lobes, double cos_theta,
                                          double alpha, double edge);

// The same from tables that are not (yet) in files.
std::array<double, 4> texel_from(const ReflectionLobeTable& table, int lobe, double cos_theta,
                                 double alpha, double edge);
glsl::f64::InterfaceEnergy energy_from(const InterfaceEnergyTable& table, double cos_theta,
                                       double alpha, double eta);
glsl::f64::InterfaceLobe lobe_from(const InterfaceLobeTable& table, int lobe, double cos_theta,
                                   double alpha, double eta);

} // namespace gg::tables
