#include "environment/zonal.h"

#include "environment/map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::environment {
namespace {

// sum over l of (2l + 1) c_l P_l(cos) at half chords, relative to its value at 0.
std::vector<float> legendre_table(const std::vector<double>& coefficients, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double half_chord = static_cast<double>(i) / (count - 1),
                 x = 1.0 - 2.0 * half_chord * half_chord;
    double before = 0.0, now = 1.0, sum = 0.0;
    for (std::size_t l = 0; l < coefficients.size(); ++l) {
      const auto degree = static_cast<double>(l);
      sum += (2.0 * degree + 1.0) * coefficients[l] * now;
      const double next = ((2.0 * degree + 1.0) * x * now - degree * before) / (degree + 1.0);
      before = now;
      now = next;
    }
    values.push_back(sum);
  }
  std::vector<float> table;
  for (double v : values)
    table.push_back(static_cast<float>(v / values[0]));
  return table;
}

} // namespace

std::vector<float> heat_kernel_table(double variance, int count) {
  std::vector<double> coefficients;
  for (int l = 0;; ++l) {
    const double c = std::exp(-0.5 * l * (l + 1.0) * variance);
    coefficients.push_back(c);
    if (c * (2 * l + 1) < 1e-9) break; // below float32's rounding of the peak
  }
  return legendre_table(coefficients, count);
}

std::vector<float> cosine_kernel_table(double blurred_variance, double kept_variance, double most,
                                       int count) {
  std::vector<double> coefficients;
  double binomial = 1.0; // l! / (2^l (l/2)!²) for even l
  for (int l = 0;; ++l) {
    const double amplified = std::exp(0.5 * l * (l + 1.0) * (blurred_variance - kept_variance));
    if (amplified > most) break;
    double a = 0.0;
    if (l == 0) a = 1.0;
    if (l == 1) a = 2.0 / 3.0;
    if (l >= 2 && l % 2 == 0) {
      binomial *= (l - 1.0) / l;
      a = 2.0 * (l / 2 % 2 ? 1.0 : -1.0) * binomial / ((l + 2.0) * (l - 1.0));
    }
    coefficients.push_back(a * amplified);
  }
  return legendre_table(coefficients, count);
}

std::vector<float> balanced_rows(int width, int height, double sigma, double reach) {
  const double step = std::numbers::pi / height;
  // Rows near a pole: at the last one the factor is 1 to 3e-4, and what it does to those before is less.
  const int near = std::min(height / 2, 24),
            overlap = static_cast<int>(std::ceil(reach * sigma / step));
  const int rows = std::min(height, near + overlap + 1);
  constexpr int readings_per_row = 16, azimuths = 64, rounds = 300;
  constexpr double relaxation =
      1.9; // below 2; plain rounds creep, as a common factor costs nothing
  const int readings = readings_per_row * near;
  // Azimuthal mean of the kernel between a reading at (i + 1/2) step / 16 and row j.
  std::vector<double> kernel(static_cast<std::size_t>(readings * rows));
  for (int i = 0; i < readings; ++i)
    for (int j = 0; j < rows; ++j) {
      const double a = (i + 0.5) * step / readings_per_row, b = (j + 0.5) * step;
      double sum = 0.0;
      for (int k = 0; k < azimuths; ++k) {
        // Square roots of uniform numbers crowd the azimuths towards 0, where narrow kernels are.
        const double s = (k + 0.5) / azimuths, azimuth = std::numbers::pi * s * s;
        const double d = std::sin(0.5 * (a - b)), e = std::sin(0.5 * azimuth);
        const double chord2 = 4.0 * (d * d + std::sin(a) * std::sin(b) * e * e);
        if (chord2 > std::pow(2.0 * std::sin(0.5 * reach * sigma), 2.0)) continue;
        sum += std::exp(-0.5 * chord2 / (sigma * sigma)) * 2.0 * s / azimuths;
      }
      kernel[static_cast<std::size_t>(i * rows + j)] = sum;
    }
  std::vector<double> area, factor(static_cast<std::size_t>(rows), 1.0);
  for (int j = 0; j < rows; ++j)
    area.push_back(width * pixel_solid_angle(width, height, j));
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> given(static_cast<std::size_t>(rows), 0.0);
    for (int i = 0; i < readings; ++i) {
      double total = 0.0;
      for (int j = 0; j < rows; ++j)
        total += kernel[static_cast<std::size_t>(i * rows + j)] * area[static_cast<std::size_t>(j)]
                 * factor[static_cast<std::size_t>(j)];
      const double ring = 2.0 * std::numbers::pi * std::sin((i + 0.5) * step / readings_per_row)
                          * step / readings_per_row;
      for (int j = 0; j < rows; ++j)
        given[static_cast<std::size_t>(j)] += ring * kernel[static_cast<std::size_t>(i * rows + j)]
                                              * factor[static_cast<std::size_t>(j)] / total;
    }
    // Rows whose readings are not all among those above keep their solid angle.
    for (int j = 0; j < near - overlap - 1; ++j)
      factor[static_cast<std::size_t>(j)] /=
          std::pow(given[static_cast<std::size_t>(j)], relaxation);
  }
  std::vector<float> balanced;
  for (int y = 0; y < height; ++y) {
    const int from_pole = std::min(y, height - 1 - y);
    balanced.push_back(static_cast<float>(
        pixel_solid_angle(width, height, y)
        * (from_pole < rows ? factor[static_cast<std::size_t>(from_pole)] : 1.0)));
  }
  return balanced;
}

} // namespace gg::environment
