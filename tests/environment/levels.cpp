// Which levels stand for a sigma: shaders/environment/gaussian_stack.glsl.
#include "glsl/f64.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::environment {
namespace {

namespace f64 = gg::glsl::f64;
constexpr double sharp = 0.003, first = 0.01, steps = 13.0; // even 0 .. 7, odd 0 .. 6

// Variance of the mix that is read.
double variance_read(double sigma) {
  const auto l = f64::gaussianStackLevels(f64::vec4(sharp, first, steps, 1.0), sigma);
  const auto even = [](double level) {
    return level < 1.0 ? (1.0 - level) * sharp * sharp + level * first * first
                       : first * first * std::pow(4.0, level - 1.0);
  };
  EXPECT_TRUE(l.even < 1.0 || l.even == std::floor(l.even))
      << sigma; // between larger levels nothing is mixed by hardware
  EXPECT_TRUE(l.even >= 0.0 && l.even <= 7.0 && l.odd >= 0.0 && l.odd <= 6.0) << sigma;
  return (1.0 - l.oddShare) * even(l.even)
         + l.oddShare * 2.0 * first * first * std::pow(4.0, l.odd);
}

TEST(gaussian_stack_levels, the_mix_has_the_variance_that_was_asked_for) {
  const double widest = first * std::pow(2.0, 0.5 * steps);
  for (double sigma = sharp; sigma < widest; sigma *= 1.01)
    EXPECT_NEAR(variance_read(sigma) / (sigma * sigma), 1.0, 1e-9) << sigma;
}

TEST(gaussian_stack_levels, end_at_the_sharpest_and_the_widest) {
  EXPECT_NEAR(variance_read(0.0), sharp * sharp, 1e-15);
  const double widest = 2.0 * first * first * std::pow(4.0, 6.0);
  for (double sigma : {0.95, 2.0, 100.0})
    EXPECT_NEAR(variance_read(sigma), widest, 1e-9 * widest) << sigma;
}

TEST(gaussian_stack_levels, rotation_turns_the_environment_counter_clockwise_seen_from_above) {
  // A quarter turn carries what was at +X to -Z: looking at -Z one sees it.
  const auto d = f64::environmentRotate(f64::vec3(0.0, 0.0, -1.0), 0.0, 1.0);
  EXPECT_NEAR(d.x, 1.0, 1e-12);
  EXPECT_NEAR(d.z, 0.0, 1e-12);
}

} // namespace
} // namespace gg::environment
