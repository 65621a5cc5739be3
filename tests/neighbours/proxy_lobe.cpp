// The closed form of a neighbour's lobe against the table of one lobe that it stands for.
#include "glsl/f64.h"
#include "tables/lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace gg::neighbours_test {
namespace {

namespace f64 = gg::glsl::f64;

constexpr double sigma_off = 0.4, albedo_off = 0.06; // of the limits that the snippet states
constexpr double sigma_rms = 0.18, albedo_rms = 0.03;

} // namespace

TEST(proxy_lobe, is_that_of_the_table) {
  double sigma_squares = 0.0, albedo_squares = 0.0, sigma_worst = 0.0, albedo_worst = 0.0;
  int count = 0;
  for (const double alpha : {0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0})
    for (const double c : {0.1, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      const auto lobe = f64::proxyLobe({std::sqrt(1.0 - c * c), 0.0, c}, {0, 0, 1}, alpha);
      const double sigma = alpha * tables::reflection_texel_at({}, 0, 1, c, alpha, 0.0)[1];
      const double albedo = tables::reflection_energy_at({}, c, alpha).albedo;
      const double s = lobe.sigma / sigma - 1.0, a = lobe.albedo - albedo;
      // At grazing angles and narrow lobes the table's are half as wide: nothing that a neighbour shows.
      if (c > 0.15) {
        EXPECT_LT(std::abs(s), sigma_off) << alpha << ' ' << c;
      }
      EXPECT_LT(std::abs(a), albedo_off) << alpha << ' ' << c;
      sigma_squares += s * s;
      albedo_squares += a * a;
      sigma_worst = std::max(sigma_worst, std::abs(s));
      albedo_worst = std::max(albedo_worst, std::abs(a));
      ++count;
    }
  std::printf("sigma rms/worst %.3f/%.3f, albedo %.3f/%.3f\n", std::sqrt(sigma_squares / count),
              sigma_worst, std::sqrt(albedo_squares / count), albedo_worst);
  EXPECT_LT(std::sqrt(sigma_squares / count), sigma_rms);
  EXPECT_LT(std::sqrt(albedo_squares / count), albedo_rms);
}

TEST(proxy_lobe, of_a_mirror_is_the_mirror_direction) {
  const auto lobe = f64::proxyLobe({0.6, 0.0, 0.8}, {0, 0, 1}, 0.0);
  EXPECT_NEAR(lobe.direction.x, -0.6, 1e-12);
  EXPECT_EQ(lobe.sigma, 0.0);
  EXPECT_NEAR(lobe.albedo, 1.0, 1e-12);
}

} // namespace gg::neighbours_test
