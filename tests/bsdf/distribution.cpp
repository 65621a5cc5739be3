// Distributions of microfacet normals: what makes D a distribution and G1 its shadowing.
#include "bsdf/quadrature.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

constexpr double pi = 3.14159265358979323846;
const std::vector<double> widths{1e-4, 1e-3, 0.01, 0.1, 0.5, 1.0, 2.0};
constexpr double smooth_quadrature = 1e-9; // 200 Gauss nodes on analytic integrands
constexpr double kinked_quadrature = 2e-5; // where |wo . m| has its kink: 1 / azimuths²

std::string label(const Distribution& m) {
  return m.name + " alpha " + std::to_string(m.alpha);
}

// Integral of D(m) max(wo . m, 0) over the upper half: the area that wo sees, shadowing aside.
double seen_area(const Distribution& m, vec3 wo) {
  return integrate_about_normal(m.alpha, 200, 400, [&](vec3 w) {
    return m.d(f64::tilt(w)) * std::max(f64::dot(wo, w), 0.0);
  });
}

TEST(distribution, projected_area_integrates_to_one) {
  for (const Distribution& m : distributions(widths)) {
    const double area =
        integrate_about_normal(m.alpha, 200, 1, [&](vec3 w) { return m.d(f64::tilt(w)) * w.z; });
    EXPECT_NEAR(area, 1, smooth_quadrature) << label(m);
  }
}

TEST(distribution, pdf_of_the_normal_sampler_integrates_to_one) {
  for (const Distribution& m : distributions(widths)) {
    const double total =
        integrate_about_normal(m.alpha, 200, 1, [&](vec3 w) { return m.pdf(f64::tilt(w)); });
    EXPECT_NEAR(total, 1, smooth_quadrature) << label(m);
  }
}

// D in the papers' own words, from the cosine: [Walter07] eq. 25, 30, 33.
TEST(distribution, is_walters_formula) {
  for (double theta : {0.05, 0.3, 0.8, 1.3})
    for (double a : {0.2, 0.5, 1.0}) {
      const Tilt m = f64::tilt(direction(theta, 1.0) * 0.37); // the length must not matter
      const double c = std::cos(theta), t2 = std::pow(std::tan(theta), 2), c4 = c * c * c * c;
      const double e = 2 / (a * a) - 2;
      constexpr double rounding = 1e-13;
      EXPECT_NEAR(f64::beckmannD(m, a) / (std::exp(-t2 / (a * a)) / (pi * a * a * c4)), 1,
                  rounding);
      EXPECT_NEAR(f64::ggxD(m, a) / (a * a / (pi * c4 * std::pow(a * a + t2, 2))), 1, rounding);
      EXPECT_NEAR(f64::phongD(m, e) / ((e + 2) / (2 * pi) * std::pow(c, e)), 1, rounding);
    }
}

TEST(distribution, phongs_exponent_and_width_convert_both_ways) {
  EXPECT_DOUBLE_EQ(f64::phongExponent(0.5), 6.0);
  EXPECT_DOUBLE_EQ(f64::phongExponent(1.0), 0.0);
  EXPECT_EQ(f64::phongExponent(2.0), 0.0);
  for (double a : {1e-4, 0.01, 0.3, 1.0})
    EXPECT_NEAR(f64::phongAlpha(f64::phongExponent(a)) / a, 1, 1e-12);
}

// [Walter07]: a plane seen through masking shows its projected area. Exact for GGX and for
// Beckmann's exact G1.
TEST(shadowing, shows_the_projected_area_of_the_plane) {
  for (double alpha : {0.1, 0.5, 1.0})
    for (double theta : {0.0, 40.0, 70.0, 85.0}) {
      const vec3 wo = direction(theta * degree, 0.0);
      const Tilt t = f64::tilt(wo);
      EXPECT_NEAR(f64::ggxG1(t, alpha) * seen_area(ggx(alpha), wo) / wo.z, 1, kinked_quadrature)
          << alpha << " " << theta;
      EXPECT_NEAR(f64::beckmannG1Exact(t, alpha) * seen_area(beckmann(alpha), wo) / wo.z, 1,
                  kinked_quadrature)
          << alpha << " " << theta;
    }
}

TEST(shadowing, visible_normals_integrate_to_one) {
  for (double alpha : {0.05, 0.5, 1.0})
    for (double theta : {0.0, 40.0, 70.0, 89.0}) {
      const vec3 wo = direction(theta * degree, 0.0);
      const double total = integrate_about_normal(alpha, 200, 400, [&](vec3 m) {
        const vec3 wi = f64::reflectAbout(wo, m);
        // The facet's own fields, as the mirror image may lie below the horizon, where no
        // reflection exists.
        Facet f = f64::reflectionFacet(wi, wo, up, 1.5);
        f.exists = f64::dot(wo, m) > 0;
        f.woDotM = f64::dot(wo, m);
        f.h = f64::tilt(m);
        return f64::ggxPdfVisible(f, alpha);
      });
      EXPECT_NEAR(total, 1, kinked_quadrature) << alpha << " " << theta;
    }
}

TEST(shadowing, rational_beckmann_is_within_its_stated_distance_of_the_exact_form) {
  double most = 0, above_one = 0;
  for (int k = 1; k < 2000; ++k) {
    const Tilt w = f64::tilt(direction(std::atan(1000.0 / k), 0.0)); // a = k / 500 at alpha 0.5
    most = std::max(most, std::abs(f64::beckmannG1(w, 0.5) - f64::beckmannG1Exact(w, 0.5)));
    above_one = std::max(above_one, f64::beckmannG1(w, 0.5) - 1);
  }
  EXPECT_LT(most, 0.0032);
  EXPECT_LT(above_one, 7e-5);
}

TEST(shadowing, exact_beckmann_is_the_error_function) {
  for (double steepness : {1e-6, 0.01, 0.5, 1.0, 1.7, 1.99, 2.01, 3.0, 5.0}) {
    const Tilt w = f64::tilt(direction(std::atan(2 / steepness), 0.0));
    const double a = w.z / (0.5 * std::sqrt(w.p));
    const double lambda = 0.5 * (std::erf(a) - 1) + std::exp(-a * a) / (2 * a * std::sqrt(pi));
    EXPECT_NEAR(f64::beckmannG1Exact(w, 0.5) * (1 + lambda), 1, 2e-14)
        << a; // the truncation in the header
    EXPECT_NEAR(f64::beckmannLambdaExact(w, 0.5) / (1 + lambda), lambda / (1 + lambda), 2e-14) << a;
  }
}

TEST(shadowing, falls_from_one_at_the_normal_to_zero_at_the_horizon) {
  for (const Distribution& m : distributions({0.01, 0.3, 1.0})) {
    EXPECT_DOUBLE_EQ(m.g1(f64::tilt(up)), 1) << label(m);
    EXPECT_EQ(m.g1(f64::tilt(vec3(1, 0, 0))), 0) << label(m);
    double before = 1 + 7e-5; // Beckmann's rational form exceeds 1 by that much
    for (int k = 0; k <= 90; ++k) {
      const double g = m.g1(f64::tilt(direction(k * degree, 0)));
      EXPECT_LE(g, before + 7e-5) << label(m) << " " << k;
      before = g;
    }
  }
}

TEST(shadowing, of_a_smooth_surface_is_none) {
  for (double theta : {0.0, 1.0, 1.57}) {
    const Tilt t = f64::tilt(direction(theta, 0));
    EXPECT_EQ(f64::ggxG1(t, 0), 1);
    EXPECT_EQ(f64::beckmannG1(t, 0), 1);
    EXPECT_EQ(f64::beckmannG1Exact(t, 0), 1);
    EXPECT_EQ(f64::ggxLambda(t, 0), 0);
  }
}

TEST(shadowing, over_the_cosines_is_the_quotient_of_the_two) {
  for (const Distribution& m : distributions({0.1, 0.7}))
    for (double a : {0.2, 1.0, 1.5})
      for (double b : {0.0, 0.9, 1.55}) {
        const Tilt i = f64::tilt(direction(a, 0)), o = f64::tilt(direction(b, 2));
        EXPECT_NEAR(m.v(i, o) / (m.g1(i) * m.g1(o) / (4 * i.z * o.z)), 1, 1e-13) << label(m);
      }
}

TEST(logarithm, near_one_keeps_its_digits) {
  for (double x : {0.0, 1e-300, 1e-12, 1e-3, 0.3, 0.999, 1.0, 1.001, 7.0, 1e9})
    EXPECT_NEAR(f64::log1pPositive(x), std::log1p(x), 1e-15 * std::log1p(x));
  EXPECT_EQ(f64::log1pPositive(-1), 0);
}

} // namespace
} // namespace gg::bsdf_test
