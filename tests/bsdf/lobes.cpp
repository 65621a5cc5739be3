// The two lobes f_r and f_t: Walter's formula, reciprocity, and their limits.
#include "bsdf/distributions.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

constexpr double rounding = 1e-11; // the papers' forms cancel; these angles leave them 11 digits

// [Walter07] eq. 20 and 21 in their own words and roles: i is where light comes from, o where it
// goes, eta_o / eta_i given.
double walter_reflection(const Distribution& d, vec3 i, vec3 o, double eta) {
  const vec3 m = f64::normalize(i + o);
  const double g = d.g1(f64::tilt(i)) * d.g1(f64::tilt(o));
  return f64::fresnelDielectricAt(f64::dot(i, m), eta) * g * d.d(f64::tilt(m))
         / (4 * std::abs(i.z * o.z));
}
double walter_transmission(const Distribution& d, vec3 i, vec3 o, double eta) {
  vec3 m = f64::normalize(-(i + eta * o));
  if (m.z * i.z < 0) m = -m;
  const double im = f64::dot(i, m), om = f64::dot(o, m);
  if (im <= 0 || om >= 0) return 0;
  const double g = d.g1(f64::tilt(i)) * d.g1(f64::tilt(o));
  const double through = 1 - f64::fresnelDielectricAt(im, eta);
  return std::abs(im * om / (i.z * o.z)) * eta * eta * through * g * d.d(f64::tilt(m))
         / std::pow(im + eta * om, 2);
}

TEST(reflection, is_walters_formula) {
  for (const Distribution& d : distributions({0.2, 0.6}))
    for (double a : {0.2, 1.0, 1.4})
      for (double eta : {0.7, 1.5}) {
        const vec3 wi = direction(a, 0.4), wo = direction(0.7, 2.5);
        EXPECT_NEAR(reflected(d, wi, wo, eta) / walter_reflection(d, wi, wo, eta), 1, rounding)
            << d.name;
      }
}

TEST(transmission, is_walters_formula_with_the_roles_exchanged) {
  int compared = 0;
  for (const Distribution& d : distributions({0.2, 0.6}))
    for (double a : {1.9, 2.6, 3.0})
      for (double eta : {0.7, 1.5}) {
        const vec3 wi = direction(a, 3.4), wo = direction(0.5, 0.2);
        const Facet f = f64::transmissionFacet(wi, wo, up, eta);
        const double walter = walter_transmission(d, wo, wi, eta);
        const double ours = f64::transmissionScatter(f, d.d(f.h), d.v(f.wi, f.wo), eta);
        if (!(walter > 0)) {
          EXPECT_EQ(ours, 0);
          continue;
        }
        EXPECT_NEAR(ours / walter, 1, rounding) << d.name << " " << a << " " << eta;
        EXPECT_NEAR(transmitted(d, wi, wo, eta) * eta * eta / walter, 1, rounding);
        ++compared;
      }
  EXPECT_GT(compared, 20);
}

TEST(reflection, is_symmetric) {
  for (const Distribution& d : distributions({0.05, 0.5, 1.0}))
    for (double a : {0.1, 0.9, 1.5})
      for (double eta : {0.6, 1.5, 4.0}) {
        const vec3 wi = direction(a, 0.3), wo = direction(1.1, 2.0);
        EXPECT_EQ(reflected(d, wi, wo, eta), reflected(d, wo, wi, eta)) << d.name;
      }
}

// [Veach97] eq. 5.14: f(wi -> wo) / n_o² is symmetric. In our words: what radiance sees one way,
// times its own side's n² squared away, is what it sees the other way with the reciprocal index.
TEST(transmission, obeys_generalised_reciprocity) {
  int compared = 0;
  for (const Distribution& d : distributions({0.05, 0.5, 1.0}))
    for (double a : {1.7, 2.3, 3.0})
      for (double b : {0.05, 0.6, 1.3})
        for (double eta : {0.6, 0.95, 1.5, 2.4}) {
          const vec3 wi = direction(a, 3.3), wo = direction(b, 0.1);
          const double forth = transmitted(d, wi, wo, eta); // eta = n_wi / n_wo
          const double back = transmitted(d, wo, wi, 1 / eta);
          if (!(forth > 1e-200)) continue;
          EXPECT_NEAR(forth * eta * eta / back, 1, rounding)
              << d.name << " " << a << " " << b << " " << eta;
          ++compared;
        }
  EXPECT_GT(compared, 100);
}

TEST(lobes, with_the_cosine_are_the_lobes_times_the_cosine) {
  const Distribution d = ggx(0.4);
  const vec3 wo = direction(0.6, 0), wr = direction(1.2, 2.5), wt = direction(2.7, 3.0);
  const Facet r = f64::reflectionFacet(wr, wo, up, 1.5),
              t = f64::transmissionFacet(wt, wo, up, 1.5);
  EXPECT_DOUBLE_EQ(f64::reflectionFCos(r, d.d(r.h), d.v(r.wi, r.wo), 1.5),
                   reflected(d, wr, wo, 1.5) * wr.z);
  EXPECT_DOUBLE_EQ(f64::transmissionFCos(t, d.d(t.h), d.v(t.wi, t.wo), 1.5),
                   transmitted(d, wt, wo, 1.5) * -wt.z);
}

// As alpha falls the lobe's mean direction becomes the mirror's and Snell's, and its energy F and 1
// - F.
TEST(lobes, narrow_to_the_mirror_and_to_snell) {
  const vec3 wo = direction(50 * degree, 0.0);
  double before_r = 1, before_t = 1;
  for (double alpha : {0.1, 0.01, 0.001}) {
    vec3 mean_r(0), mean_t(0);
    double energy_r = 0, energy_t = 0;
    constexpr int n = 200;
    for (int i = 0; i < n * n; ++i) {
      const vec2 u((i % n + 0.5) / n, (i / n + 0.5) / n);
      const vec3 m = f64::ggxSampleVisible(wo, vec2(alpha), u);
      const double f = f64::fresnelDielectricAt(f64::dot(wo, m), 1.5);
      const vec3 r = f64::reflectAbout(wo, m), t = f64::refractAbout(wo, m, 1.5);
      const double wr = r.z > 0 ? f * f64::ggxG1(f64::tilt(r), alpha) / n / n : 0;
      const double wt = t.z < 0 ? (1 - f) * f64::ggxG1(f64::tilt(t), alpha) / n / n : 0;
      mean_r += wr * r;
      mean_t += wt * t;
      energy_r += wr;
      energy_t += wt;
    }
    const double off_r = f64::distance(f64::normalize(mean_r), f64::reflectAbout(wo, up));
    const double off_t = f64::distance(f64::normalize(mean_t), f64::refractAbout(wo, up, 1.5));
    EXPECT_LT(off_r, before_r);
    EXPECT_LT(off_t, before_t);
    before_r = off_r;
    before_t = off_t;
    if (alpha == 0.001) {
      // GGX's tail beyond angle x holds (alpha / x)² of the normals: energies to about alpha.
      EXPECT_NEAR(energy_r, f64::fresnelDielectricAt(wo.z, 1.5), alpha);
      EXPECT_NEAR(energy_t, f64::fresnelTransmittedAt(wo.z, 1.5), alpha);
      EXPECT_LT(off_r, 10 * alpha);
      EXPECT_LT(off_t, 10 * alpha);
    }
  }
}

TEST(lobes, of_a_smooth_surface_have_no_finite_part) {
  const vec3 wo = direction(0.6, 0);
  for (const Distribution& d : {ggx(0.0), beckmann(0.0)}) {
    EXPECT_EQ(reflected(d, f64::reflectAbout(wo, up), wo, 1.5), 0) << d.name;
    EXPECT_EQ(reflected(d, direction(0.3, 1), wo, 1.5), 0) << d.name;
    EXPECT_EQ(transmitted(d, f64::refractAbout(wo, up, 1.5), wo, 1.5), 0) << d.name;
    EXPECT_EQ(d.sample(vec2(0.7, 0.3)), up) << d.name;
  }
  EXPECT_EQ(f64::ggxSampleVisible(wo, vec2(0), vec2(0.7, 0.3)), up);
}

TEST(lobes, of_matched_indices_have_no_finite_part) {
  const vec3 wo = direction(0.6, 0);
  for (const Distribution& d : distributions({0.3})) {
    EXPECT_EQ(reflected(d, direction(0.3, 1), wo, 1.0), 0);
    EXPECT_EQ(transmitted(d, -wo, wo, 1.0), 0);
    EXPECT_EQ(transmitted(d, direction(2.5, 3), wo, 1.0), 0);
  }
}

TEST(multiple_scattering, lobe_is_reciprocal_and_returns_what_was_lost) {
  const double e_avg = 0.7;
  EXPECT_EQ(f64::multipleScatteringF(0.6, 0.8, e_avg), f64::multipleScatteringF(0.8, 0.6, e_avg));
  EXPECT_EQ(f64::multipleScatteringF(1, 1, 1), 0);
  // With any albedo e(c) of mean e_avg: 2 pi ∫ f c dc = (1 - e_o). Here e(c) = 0.5 + 0.3 c, mean
  // 0.7.
  double total = 0;
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i) {
    const double c = (i + 0.5) / n;
    total += f64::multipleScatteringF(0.5 + 0.3 * c, 0.55, e_avg) * c * 2 * 3.14159265358979 / n;
  }
  EXPECT_NEAR(total, 0.45, 1e-6); // midpoint rule
  EXPECT_DOUBLE_EQ(f64::multipleFresnel(1.0, 0.3), 1.0);
  EXPECT_EQ(f64::multipleFresnel(0.0, 0.3), 0.0);
  EXPECT_EQ(f64::multipleFresnelRgb(vec3(0.5), 0.3).y, f64::multipleFresnel(0.5, 0.3));
}

} // namespace
} // namespace gg::bsdf_test
