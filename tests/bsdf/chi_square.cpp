#include "bsdf/chi_square.h"

#include <random>

namespace gg::bsdf_test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int rings = 24, sectors = 24, samples = 100000;
constexpr int fine =
    12; // density points per cell and axis: density edges cost less than the counting noise

// Rings of t in [0, 1], with tan(theta) = alpha tan(t pi / 2).
double ring_of(double theta, double alpha) {
  return std::atan2(std::sin(theta), alpha * std::cos(theta)) / (0.5 * pi);
}
double theta_of(double ring, double alpha) {
  return std::atan2(alpha * std::sin(ring * 0.5 * pi), std::cos(ring * 0.5 * pi));
}

// Chance of chi² >= x, by Wilson and Hilferty's cube-root normal: good to a percent of itself above
// 30 degrees of freedom.
double tail(double x, int degrees) {
  const double v = 2.0 / (9.0 * degrees);
  return 0.5 * std::erfc((std::cbrt(x / degrees) - (1 - v)) / std::sqrt(2 * v));
}

} // namespace

ChiSquare chi_square(const Cells& cells, const std::function<vec3(vec2)>& sample,
                     const std::function<double(vec3)>& density, std::uint64_t seed) {
  const int fine = cells.fine;
  std::vector<double> expected(rings * sectors + 1), counted(rings * sectors + 1);
  ChiSquare result;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sectors; ++s) {
      double total = 0;
      for (int i = 0; i < fine; ++i) {
        const double low = theta_of((r + double(i) / fine) / rings, cells.alpha);
        const double high = theta_of((r + double(i + 1) / fine) / rings, cells.alpha);
        const double middle = theta_of((r + (i + 0.5) / fine) / rings, cells.alpha);
        const double area = std::cos(low) - std::cos(high);
        for (int k = 0; k < fine; ++k) {
          const double phi = 2 * pi * (s + (k + 0.5) / fine) / sectors;
          vec3 w = direction(middle, phi);
          w.z *= cells.side;
          total += density(w) * area * 2 * pi / sectors / fine;
        }
      }
      expected[r * sectors + s] = total * samples;
      result.inside += total;
    }
  expected.back() = std::max(1 - result.inside, 0.0) * samples;

  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int n = 0; n < samples; ++n) {
    const double a = uniform(random), b = uniform(random);
    vec3 w = sample(vec2(a, b));
    w.z *= cells.side;
    if (!(w.z > 0) || !(density(vec3(w.x, w.y, w.z * cells.side)) > 0)) {
      ++counted.back();
      continue;
    }
    const double theta = std::atan2(std::hypot(w.x, w.y), w.z);
    const double phi = std::atan2(w.y, w.x);
    const int r = std::min(int(ring_of(theta, cells.alpha) * rings), rings - 1);
    const int s = std::min(int((phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * sectors), sectors - 1);
    ++counted[r * sectors + s];
  }

  double pooled_expected = 0, pooled_counted = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] < 5) {
      pooled_expected += expected[i];
      pooled_counted += counted[i];
      continue;
    }
    result.statistic += (counted[i] - expected[i]) * (counted[i] - expected[i]) / expected[i];
    ++result.degrees;
  }
  if (pooled_expected > 0) {
    // At least one expected sample, so that an integration error in empty cells does not count as a
    // discovery.
    result.statistic +=
        std::pow(pooled_counted - pooled_expected, 2) / std::max(pooled_expected, 1.0);
    ++result.degrees;
  }
  --result.degrees; // the counts sum to the number of samples
  result.p = tail(result.statistic, result.degrees);
  return result;
}

} // namespace gg::bsdf_test
