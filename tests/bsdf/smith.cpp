// Shadowing and masking together: separable, correlated in height, and the Beta form of
// transmission.
#include "bsdf/distributions.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

TEST(smith, beta_form_is_the_beta_function) {
  for (double a : {0.0, 1e-6, 0.3, 1.0, 3.7, 10.0, 40.0})
    for (double b : {0.0, 1e-3, 0.5, 2.0, 30.0}) {
      const double beta =
          std::exp(std::lgamma(1 + a) + std::lgamma(1 + b) - std::lgamma(2 + a + b));
      EXPECT_NEAR(f64::smithG2Beta(a, b) / beta, 1, 1e-11)
          << a << " " << b; // Stirling's remainder at 7
      EXPECT_NEAR(f64::smithG2Beta(b, a) / f64::smithG2Beta(a, b), 1, 1e-12) << a << " " << b;
    }
}

TEST(smith, beta_form_with_one_lambda_zero_is_g1) {
  for (double l : {0.0, 0.1, 5.0, 1e6})
    EXPECT_NEAR(f64::smithG2Beta(l, 0) * (1 + l), 1, 1e-10) << l;
}

TEST(smith, beta_form_survives_any_angle) {
  for (double l : {0.0, 1.0, 1e3, 1e30})
    for (double m : {0.0, 2.0, 1e30}) {
      const double g = f64::smithG2Beta(l, m);
      EXPECT_TRUE(g >= 0 && g <= 1) << l << " " << m;
    }
}

TEST(smith, correlated_reflection_hides_least_and_transmission_most) {
  for (double alpha : {0.2, 0.6, 1.0})
    for (double a : {0.2, 0.9, 1.4, 1.55})
      for (double b : {0.1, 1.0, 1.5}) {
        const Tilt i = f64::tilt(direction(a, 0)), o = f64::tilt(direction(b, 1));
        const double separable = f64::ggxG2(i, o, alpha);
        const double correlated = f64::ggxG2Correlated(i, o, alpha);
        EXPECT_LE(f64::ggxG2Beta(i, o, alpha), separable * (1 + 1e-12));
        EXPECT_LE(separable, correlated * (1 + 1e-12));
        EXPECT_LE(correlated, std::min(f64::ggxG1(i, alpha), f64::ggxG1(o, alpha)) * (1 + 1e-12));
        EXPECT_NEAR(correlated * (1 + f64::ggxLambda(i, alpha) + f64::ggxLambda(o, alpha)), 1,
                    1e-13);
        EXPECT_NEAR(f64::ggxG1(i, alpha) * (1 + f64::ggxLambda(i, alpha)), 1, 1e-13);
        const double cosines = 4 * i.z * o.z;
        EXPECT_NEAR(f64::ggxVCorrelated(i, o, alpha) * cosines / correlated, 1, 1e-13);
        EXPECT_NEAR(f64::ggxVBeta(i, o, alpha) * cosines / f64::ggxG2Beta(i, o, alpha), 1, 1e-13);
      }
}

} // namespace
} // namespace gg::bsdf_test
