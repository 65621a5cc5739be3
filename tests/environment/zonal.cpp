// Kernels of the angle against closed forms.
#include "environment/zonal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gg::environment {
namespace {

constexpr int count = 2001;

// Of the zonal function with these values at equal half chords, the mean of P_l: x = 1 - 2 h², dx = 4 h dh.
double degree(const std::vector<float>& table, int l) {
  double sum = 0.0, norm = 0.0;
  for (int i = 0; i < count; ++i) {
    const double h = static_cast<double>(i) / (count - 1),
                 weight = (i % (count - 1) ? 1.0 : 0.5) * h;
    const double value = weight * static_cast<double>(table[static_cast<std::size_t>(i)]);
    sum += value * std::legendre(static_cast<unsigned>(l), 1.0 - 2.0 * h * h);
    norm += value;
  }
  return sum / norm;
}

TEST(zonal, heat_kernel_damps_every_degree_as_the_heat_equation_does) {
  for (const double sigma : {0.15, 0.4, 0.9}) {
    const auto table = heat_kernel_table(sigma * sigma, count);
    for (int l = 0; l <= 8; ++l) // trapezium rule over 2000 intervals: (l / 2000)²
      EXPECT_NEAR(degree(table, l), std::exp(-0.5 * l * (l + 1) * sigma * sigma), 2e-5)
          << sigma << ' ' << l;
  }
}

TEST(zonal, cosine_kernel_undoes_the_blur_of_its_source) {
  const double variance = 0.0122;
  const auto table = cosine_kernel_table(variance, 0.0, 20.0, count);
  // [RamamoorthiHanrahan01] eq. 8: 1, 2/3, 1/4, 0, -1/24, 0, 1/64
  const double expected[] = {1.0, 2.0 / 3.0, 0.25, 0.0, -1.0 / 24.0, 0.0, 1.0 / 64.0};
  for (int l = 0; l <= 6; ++l)
    EXPECT_NEAR(degree(table, l) * std::exp(-0.5 * l * (l + 1) * variance), expected[l], 2e-5) << l;
}

TEST(zonal, row_balance_is_one_away_from_the_poles_and_grows_to_them) {
  const int width = 256, height = 128;
  const auto rows = balanced_rows(width, height, 0.6 * std::numbers::pi / height, 4.0);
  ASSERT_EQ(rows.size(), 128u);
  const auto area = [&](int y) {
    return 2.0 * std::numbers::pi / width
           * (std::cos(std::numbers::pi * y / height)
              - std::cos(std::numbers::pi * (y + 1) / height));
  };
  for (int y = 30; y < 98; ++y)
    EXPECT_NEAR(static_cast<double>(rows[static_cast<std::size_t>(y)]) / area(y), 1.0, 1e-6);
  for (int y = 0; y < 10; ++y) {
    EXPECT_GT(static_cast<double>(rows[static_cast<std::size_t>(y)]) / area(y), 1.0) << y;
    EXPECT_FLOAT_EQ(rows[static_cast<std::size_t>(y)],
                    rows[static_cast<std::size_t>(height - 1 - y)]);
  }
}

} // namespace
} // namespace gg::environment
