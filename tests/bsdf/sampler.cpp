// Samplers against the densities that they claim, and the weights that a path tracer divides by
// them.
#include "bsdf/chi_square.h"
#include "bsdf/quadrature.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

// All chi-square tests of this file together are wrong by chance once in a thousand seeds
// (Bonferroni).
constexpr int comparisons = 200;
constexpr double significance = 1e-3 / comparisons;
constexpr std::uint64_t seed = 1967;
constexpr double cell_quadrature = 5e-3; // the midpoint grid inside the cells, at density edges

void expect_match(const ChiSquare& c, const std::string& what) {
  EXPECT_GT(c.p, significance) << what << ": chi² " << c.statistic << " at " << c.degrees
                               << " degrees of freedom";
  EXPECT_GE(c.degrees, 30) << what; // below, the test says little and its p-value is rough
}

std::string label(const std::string& name, double alpha, double theta) {
  return name + " alpha " + std::to_string(alpha) + " at " + std::to_string(theta) + " degrees";
}

TEST(sampler, histogram_of_normals_matches_their_pdf) {
  for (const Distribution& d : distributions({0.001, 0.1, 0.5, 1.0})) {
    const ChiSquare c = chi_square(
        {d.alpha}, d.sample, [&](vec3 m) { return d.pdf(f64::tilt(m)); }, seed);
    expect_match(c, label(d.name, d.alpha, 0));
    EXPECT_NEAR(c.inside, 1, cell_quadrature);
  }
}

// The density of a visible normal, for any m that wo sees.
double visible_pdf(vec3 wo, vec3 m, vec2 alpha) {
  Facet f = f64::reflectionFacet(wo, wo, up, 1.5);
  f.woDotM = f64::dot(wo, m);
  f.h = f64::tilt(m);
  f.exists = f.woDotM > 0;
  return alpha.x == alpha.y ? f64::ggxPdfVisible(f, alpha.x)
                            : f64::ggxAnisoPdfVisible(f, m, wo, alpha);
}

TEST(sampler, histogram_of_visible_normals_matches_their_pdf) {
  for (vec2 alpha : {vec2(0.01), vec2(0.3), vec2(1.0), vec2(0.2, 0.8)})
    for (double theta : {0.0, 45.0, 80.0, 89.0}) {
      const vec3 wo = direction(theta * degree, 0.7);
      const ChiSquare c = chi_square(
          {std::sqrt(alpha.x * alpha.y)},
          [&](vec2 u) { return f64::ggxSampleVisible(wo, alpha, u); },
          [&](vec3 m) { return visible_pdf(wo, m, alpha); }, seed + 1);
      expect_match(c, label("visible", alpha.x, theta));
      EXPECT_NEAR(c.inside, 1, cell_quadrature);
    }
}

TEST(sampler, histogram_of_anisotropic_normals_matches_their_pdf) {
  for (vec2 alpha : {vec2(0.1, 0.4), vec2(0.9, 0.3)})
    expect_match(chi_square(
                     {std::sqrt(alpha.x * alpha.y)},
                     [&](vec2 u) { return f64::ggxAnisoSample(alpha, u); },
                     [&](vec3 m) { return f64::ggxAnisoPdf(m, alpha); }, seed + 2),
                 label("anisotropic", alpha.x, 0));
}

TEST(sampler, histogram_of_reflected_directions_matches_their_pdf) {
  for (double alpha : {0.3, 0.7})
    for (double theta : {0.0, 50.0, 80.0}) {
      const vec3 wo = direction(theta * degree, 0.2);
      for (const Distribution& d : distributions({alpha})) {
        const auto pdf = [&](vec3 wi) {
          const Facet f = f64::reflectionFacet(wi, wo, up, 1.5);
          return f64::reflectionPdf(f, d.pdf(f.h));
        };
        expect_match(
            chi_square(
                {1}, [&](vec2 u) { return f64::reflectAbout(wo, d.sample(u)); }, pdf, seed + 3),
            label(d.name, alpha, theta));
      }
      const auto visible = [&](vec3 wi) {
        const Facet f = f64::reflectionFacet(wi, wo, up, 1.5);
        return f64::reflectionPdf(f, f64::ggxPdfVisible(f, alpha));
      };
      expect_match(chi_square(
                       {1},
                       [&](vec2 u) {
                         return f64::reflectAbout(wo, f64::ggxSampleVisible(wo, vec2(alpha), u));
                       },
                       visible, seed + 4),
                   label("visible", alpha, theta));
    }
}

TEST(sampler, histogram_of_refracted_directions_matches_their_pdf) {
  for (double eta : {1.5, 1 / 1.5})
    for (double theta :
         {10.0, 30.0, eta > 1 ? 75.0 : 40.0}) { // out of glass little is left past 42
      const double alpha = 0.4;
      const vec3 wo = direction(theta * degree, 0.2);
      // A facet that wo sees from behind refracts nothing towards wo: such draws are rejected.
      const auto refract = [&](vec3 m) {
        return f64::dot(wo, m) > 0 ? f64::refractAbout(wo, m, eta) : vec3(0);
      };
      for (const Distribution& d : distributions({alpha})) {
        const auto pdf = [&](vec3 wi) {
          const Facet f = f64::transmissionFacet(wi, wo, up, eta);
          return f64::transmissionPdf(f, d.pdf(f.h), eta);
        };
        expect_match(chi_square(
                         {1, -1, 40}, [&](vec2 u) { return refract(d.sample(u)); }, pdf, seed + 5),
                     label(d.name, eta, theta));
      }
      const auto visible = [&](vec3 wi) {
        const Facet f = f64::transmissionFacet(wi, wo, up, eta);
        return f64::transmissionPdf(f, f64::ggxPdfVisible(f, alpha), eta);
      };
      expect_match(chi_square(
                       {1, -1, 40},
                       [&](vec2 u) { return refract(f64::ggxSampleVisible(wo, vec2(alpha), u)); },
                       visible, seed + 6),
                   label("visible", eta, theta));
    }
}

TEST(sampler, weights_of_visible_normals_never_exceed_one) {
  constexpr double rounding = 1e-9; // f and pdf round apart where wi and wo nearly cancel
  int compared = 0;
  for (double alpha : {0.01, 0.3, 1.0})
    for (double theta : {0.0, 50.0, 80.0, 89.5})
      for (double eta : {0.6, 1.5}) {
        const vec3 wo = direction(theta * degree, 0.0);
        mean_over_square(24, [&](vec2 u) {
          const vec3 m = f64::ggxSampleVisible(wo, vec2(alpha), u);
          const vec3 r = f64::reflectAbout(wo, m), t = f64::refractAbout(wo, m, eta);
          const Distribution d = ggx(alpha);
          const Facet fr = f64::reflectionFacet(r, wo, up, eta),
                      ft = f64::transmissionFacet(t, wo, up, eta);
          if (fr.exists) {
            const double weight = f64::reflectionFCos(fr, d.d(fr.h), d.v(fr.wi, fr.wo), eta)
                                  / f64::reflectionPdf(fr, f64::ggxPdfVisible(fr, alpha));
            EXPECT_NEAR(weight, f64::fresnelDielectric(fr.woDotM, fr.g, eta) * d.g1(fr.wi),
                        rounding);
            EXPECT_LE(weight, 1 + rounding);
            ++compared;
          }
          if (ft.exists && f64::dot(t, t) > 0) {
            const double weight = f64::transmissionScatter(ft, d.d(ft.h), d.v(ft.wi, ft.wo), eta)
                                  * ft.wi.z
                                  / f64::transmissionPdf(ft, f64::ggxPdfVisible(ft, alpha), eta);
            EXPECT_LE(weight, 1 + rounding);
            EXPECT_NEAR(weight, f64::fresnelTransmitted(ft.woDotM, ft.g, eta) * d.g1(ft.wi),
                        rounding);
            ++compared;
          }
          return 0.0;
        });
      }
  EXPECT_GT(compared, 10000);
}

TEST(sampler, directions_are_unit) {
  for (const Distribution& d : distributions({1e-4, 0.3, 1.0}))
    for (double a : {0.0, 1e-12, 0.5, 0.999999999999})
      for (double b : {0.0, 0.4, 0.999999999999}) {
        const vec3 m = d.sample(vec2(a, b));
        EXPECT_NEAR(f64::length(m), 1, 1e-12) << d.name << " " << a << " " << b;
        EXPECT_GE(m.z, 0);
        const vec3 v =
            f64::ggxSampleVisible(direction(89.9999 * degree, 1), vec2(d.alpha), vec2(a, b));
        EXPECT_NEAR(f64::length(v), 1, 1e-12);
        EXPECT_GE(v.z, 0);
      }
}

} // namespace
} // namespace gg::bsdf_test
