// Half-vectors of reflection and refraction: Snell, mirrors, and Jacobians against finite
// differences.
#include "bsdf/distributions.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

constexpr double rounding = 1e-13;

// Solid angle ratio dω_m / dω_i at fixed wo, from the parallelogram that two small turns of wi make
// of m.
double finite_difference(const std::function<vec3(vec3)>& half, vec3 wi) {
  constexpr double step =
      1e-5; // central differences: error step² = 1e-10, rounding 1e-16 / step = 1e-11
  const vec3 a =
      f64::normalize(f64::cross(wi, std::abs(wi.x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 1, 0)));
  const vec3 b = f64::cross(wi, a);
  const auto turned = [&](vec3 towards) {
    const vec3 plus = half(f64::normalize(wi + step * towards));
    const vec3 minus = half(f64::normalize(wi - step * towards));
    return (plus - minus) / (2 * step);
  };
  return f64::length(f64::cross(turned(a), turned(b)));
}
constexpr double difference_error = 1e-7; // with the curvature of m(wi) at the grazing cases below

TEST(half_vector, of_reflection_mirrors) {
  const vec3 m = direction(0.4, 1.0);
  for (double theta : {0.1, 0.7, 1.2}) {
    const vec3 wo = direction(theta, 0.3), wi = f64::reflectAbout(wo, m);
    const vec3 h = f64::normalize(f64::reflectionHalf(wi, wo));
    EXPECT_NEAR(f64::distance(h, m), 0, rounding);
    const Facet f = f64::reflectionFacet(wi, wo, up, 1.5);
    EXPECT_NEAR(f.woDotM, f64::dot(wo, m), rounding);
    EXPECT_NEAR(f.g, f64::fresnelG(f64::dot(wo, m), 1.5), rounding);
  }
}

TEST(half_vector, of_refraction_obeys_snells_law) {
  for (double eta : {0.5, 0.7, 1.05, 1.5, 2.4})
    for (double theta : {0.0, 0.2, 0.4}) {
      const vec3 m = direction(0.2, 2.0), wo = direction(theta, 0.3);
      const vec3 wi = f64::refractAbout(wo, m, eta);
      ASSERT_GT(f64::dot(wi, wi), 0);
      EXPECT_NEAR(f64::length(wi), 1, rounding);
      // n_known sin = n_far sin: the parts across m are opposite, and in that ratio.
      EXPECT_NEAR(f64::distance(f64::cross(m, wo), eta * f64::cross(wi, m)), 0, rounding);
      const Facet f = f64::transmissionFacet(wi, wo, up, eta);
      ASSERT_TRUE(f.exists);
      const vec3 h = f64::normalize(f64::transmissionHalf(wi, wo, eta));
      EXPECT_NEAR(std::abs(f64::dot(h, m)), 1, rounding);
      EXPECT_NEAR(f.woDotM, f64::dot(wo, m), 1e-12);
      EXPECT_NEAR(f.wiDotM, -f64::dot(wi, m), 1e-12);
    }
}

TEST(half_vector, of_refraction_squared_is_walters_denominator) {
  const vec3 wo = direction(0.5, 0), wi = direction(2.9, 3);
  for (double eta : {0.6, 1.5}) {
    const Facet f = f64::transmissionFacet(wi, wo, up, eta);
    ASSERT_TRUE(f.exists);
    EXPECT_NEAR(f.s, std::pow(f.woDotM - eta * f.wiDotM, 2), rounding);
  }
}

TEST(refraction, past_the_critical_angle_has_no_direction) {
  const vec3 wo = direction(45 * degree, 0.0); // critical for 1 / 1.5: 41.8 degrees
  EXPECT_EQ(f64::refractAbout(wo, up, 1 / 1.5), vec3(0.0));
  EXPECT_EQ(f64::refractAbout(wo, up, 0.0), vec3(0.0));
}

TEST(refraction, does_not_care_which_side_the_facet_normal_points_to) {
  const vec3 wo = direction(0.5, 1.0), m = direction(0.3, 2.0);
  EXPECT_EQ(f64::refractAbout(wo, m, 1.5), f64::refractAbout(wo, -m, 1.5));
  EXPECT_EQ(f64::reflectAbout(wo, m), f64::reflectAbout(wo, -m));
}

TEST(refraction, goes_straight_on_as_the_indices_meet) {
  const vec3 wo = direction(1.2, 1.0), m = direction(0.3, 2.0);
  EXPECT_EQ(f64::refractAbout(wo, m, 1.0), -wo);
  EXPECT_NEAR(f64::distance(f64::refractAbout(wo, m, 1 + 1e-9), -wo), 0, 1e-8);
}

TEST(jacobian, of_reflection_equals_finite_differences) {
  for (double theta : {0.2, 0.8, 1.4})
    for (double phi : {0.1, 2.0}) {
      const vec3 wo = direction(0.6, 0.0), wi = direction(theta, phi);
      const Facet f = f64::reflectionFacet(wi, wo, up, 1.5);
      const double numeric =
          finite_difference([&](vec3 w) { return f64::normalize(f64::reflectionHalf(w, wo)); }, wi);
      EXPECT_NEAR(f64::reflectionJacobian(f) / numeric, 1, difference_error);
    }
}

TEST(jacobian, of_refraction_equals_finite_differences) {
  int compared = 0;
  for (double eta : {0.5, 0.8, 1.1, 1.5, 2.4})
    for (double theta : {1.8, 2.4, 3.0})
      for (double phi : {0.1, 2.0, 3.0}) {
        const vec3 wo = direction(0.6, 0.0), wi = direction(theta, phi);
        const Facet f = f64::transmissionFacet(wi, wo, up, eta);
        if (!f.exists) continue;
        const double numeric = finite_difference(
            [&](vec3 w) { return f64::normalize(f64::transmissionHalf(w, wo, eta)); }, wi);
        EXPECT_NEAR(f64::transmissionJacobian(f, eta) / numeric, 1, 1e-5) << eta << " " << theta;
        ++compared;
      }
  EXPECT_GE(compared, 19);
}

TEST(half_vector, is_the_same_in_any_frame) {
  // Turn everything: tilts, cosines and Fresnel's g may not change.
  const vec3 z = direction(0.9, 2.5);
  const vec3 x = f64::normalize(f64::cross(vec3(0, 0, 1), z)), y = f64::cross(z, x);
  const auto turn = [&](vec3 v) { return v.x * x + v.y * y + v.z * z; };
  const vec3 wo = direction(0.7, 0.2);
  for (double theta : {0.3, 1.2, 2.2, 2.9}) {
    const vec3 wi = direction(theta, 2.8);
    const bool reflects = wi.z > 0;
    const Facet a =
        reflects ? f64::reflectionFacet(wi, wo, up, 1.5) : f64::transmissionFacet(wi, wo, up, 1.5);
    const Facet b = reflects ? f64::reflectionFacet(turn(wi), turn(wo), z, 1.5)
                             : f64::transmissionFacet(turn(wi), turn(wo), z, 1.5);
    ASSERT_TRUE(a.exists && b.exists);
    for (auto [p, q] : {std::pair(a.wi, b.wi), std::pair(a.wo, b.wo), std::pair(a.h, b.h)}) {
      EXPECT_NEAR(p.p, q.p, rounding);
      EXPECT_NEAR(p.z, q.z, rounding);
    }
    EXPECT_NEAR(a.woDotM, b.woDotM, rounding);
    EXPECT_NEAR(a.wiDotM, b.wiDotM, rounding);
    EXPECT_NEAR(a.g, b.g, rounding);
  }
}

TEST(half_vector, tilt_in_the_local_frame_is_tilt_about_z) {
  const vec3 w = direction(1.1, 0.4) * 3.0;
  const Tilt a = f64::tilt(w), b = f64::tiltAbout(w, up);
  EXPECT_NEAR(a.p, b.p, rounding);
  EXPECT_EQ(a.z, b.z);
  EXPECT_NEAR(f64::tiltCos(a), std::cos(1.1), rounding);
}

} // namespace
} // namespace gg::bsdf_test
