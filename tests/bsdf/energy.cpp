// Where the light goes: single scattering loses some, a random walk between the facets says where
// it went.
#include "bsdf/quadrature.h"
#include "bsdf/smith_walk.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

constexpr int walks = 60000;
constexpr double walk_error = 4.5 * 0.5 / 245.0; // 4.5 standard errors, 0.5 / sqrt(walks) each
constexpr std::uint64_t seed = 20070625;

TEST(energy, reflected_transmitted_and_walked_sum_to_one) {
  for (double eta : {1.5, 1 / 1.5})
    for (double alpha : {0.2, 0.5, 1.0})
      for (double theta : {0.0, 60.0, 80.0}) {
        const Energy once = single_scattering(theta * degree, alpha, eta, Smith::correlated);
        const WalkEnergy walk = walk_dielectric(std::cos(theta * degree), alpha, eta, walks, seed);
        const std::string where =
            std::to_string(eta) + " " + std::to_string(alpha) + " " + std::to_string(theta);
        EXPECT_NEAR(once.reflected, walk.reflected_once, walk_error + grid_error) << where;
        EXPECT_NEAR(once.transmitted, walk.transmitted_once, walk_error + grid_error) << where;
        EXPECT_NEAR(once.lost(), walk.reflected_more + walk.transmitted_more,
                    walk_error + grid_error)
            << where;
        EXPECT_EQ(walk.trapped, 0) << where;
      }
}

// The figures that shaders/README.md states for the separable form.
TEST(energy, separable_shadowing_loses_the_stated_share) {
  struct Row {
    double eta, theta, lost, difference; // lost, and what correlated loses beyond it
  };
  constexpr double printed = 6e-4; // last digit below, and the grid
  for (const Row& row : {Row{1.5, 0, 0.0318, 0.0}, Row{1.5, 60, 0.1174, 0.0057},
                         Row{1.5, 80, 0.2479, 0.0694}, Row{1 / 1.5, 0, 0.2461, 0.0},
                         Row{1 / 1.5, 60, 0.3573, -0.0023}, Row{1 / 1.5, 80, 0.3952, -0.0255}}) {
    const double separable =
        single_scattering(row.theta * degree, 0.5, row.eta, Smith::separable).lost();
    const double correlated =
        single_scattering(row.theta * degree, 0.5, row.eta, Smith::correlated).lost();
    EXPECT_NEAR(separable, row.lost, printed) << row.eta << " " << row.theta;
    EXPECT_NEAR(correlated - separable, row.difference, 2 * printed) << row.eta << " " << row.theta;
  }
}

TEST(energy, the_grid_has_converged) {
  const auto half_grid = [](double theta) {
    const vec3 wo = direction(theta, 0);
    return mean_over_square(128, [&](vec2 u) {
      const vec3 r = f64::reflectAbout(wo, f64::ggxSampleVisible(wo, vec2(1.0), u));
      return r.z > 0 ? f64::ggxG1(f64::tilt(r), 1.0) : 0.0;
    });
  };
  for (double theta : {0.0, 1.0, 1.4})
    EXPECT_NEAR(lossless_albedo(theta, 1.0, Smith::separable), half_grid(theta), grid_error);
}

TEST(energy, of_ggx_and_beckmann_is_never_gained) {
  for (double alpha : {0.1, 0.5, 1.0})
    for (double theta : {0.0, 60.0, 85.0, 89.0})
      for (Smith smith : {Smith::separable, Smith::correlated}) {
        EXPECT_LE(lossless_albedo(theta * degree, alpha, smith), 1);
        for (double eta : {0.5, 0.9, 1.5, 4.0})
          EXPECT_GE(single_scattering(theta * degree, alpha, eta, smith).lost(), 0);
      }
}

// Albedo of a lossless surface, over the facets: dω_i = 4 |wo . wm| dω_m.
double furnace(const Distribution& d, double theta) {
  const vec3 wo = direction(theta, 0);
  return integrate_about_normal(d.alpha, 300, 600, [&](vec3 m) {
    const vec3 wi = f64::reflectAbout(wo, m);
    const Facet f = f64::reflectionFacet(wi, wo, up, 1.5);
    if (!(f64::dot(wo, m) > 0)) return 0.0;
    return f64::reflectionLobe(f, d.d(f64::tilt(m)), d.v(f.wi, f.wo)) * f.wi.z * 4 * f.woDotM;
  });
}

// The area of facets that wo sees, over what there is to see: 1 for a consistent pair of D and G1,
// and a bound on the albedo.
double weak_furnace(const Distribution& d, double theta) {
  const vec3 wo = direction(theta, 0);
  const double seen = integrate_about_normal(d.alpha, 300, 600, [&](vec3 m) {
    return d.d(f64::tilt(m)) * std::max(f64::dot(wo, m), 0.0);
  });
  return d.g1(f64::tilt(wo)) * seen / wo.z;
}

TEST(energy, phong_gains_what_its_header_says_and_no_more) {
  constexpr double printed = 2e-3;    // the header's last digit
  constexpr double rational = 1.0035; // Beckmann's rational G1 is that close to the exact one
  for (double alpha : {0.1, 0.5, 1.0})
    for (double theta : {0.0, 60.0, 85.0, 89.9}) {
      EXPECT_LE(furnace(phong(alpha), theta * degree),
                weak_furnace(phong(alpha), theta * degree) * rational);
      EXPECT_LE(furnace(beckmann(alpha), theta * degree), rational) << alpha << " " << theta;
      EXPECT_LE(furnace(phong(alpha), theta * degree), 1.34) << alpha << " " << theta;
      EXPECT_LE(weak_furnace(phong(alpha), theta * degree), 1.77) << alpha << " " << theta;
    }
  EXPECT_NEAR(weak_furnace(phong(0.5), 85 * degree), 1.083, printed);
  EXPECT_NEAR(furnace(phong(0.5), 85 * degree), 1.021, printed);
  EXPECT_NEAR(furnace(phong(1.0), 89.9 * degree), 1.337, printed);
}

TEST(multiple_scattering, split_follows_the_walk_as_its_header_says) {
  double worst_in = 0, worst_out = 0, worst_any = 0, squares = 0;
  int count = 0;
  for (double n : {1.1, 1.5, 2.4})
    for (double alpha : {0.1, 0.5, 1.0})
      for (double c : {1.0, 0.5, 0.1})
        for (double eta : {n, 1 / n}) {
          const WalkEnergy w = walk_dielectric(c, alpha, eta, walks / 3, seed);
          const f64::SplitEnergy split =
              f64::multipleScatteringSplit(w.reflected_once, w.transmitted_once, c, alpha, eta);
          EXPECT_DOUBLE_EQ(split.reflected + split.transmitted, 1);
          const double off = std::abs(split.reflected - w.reflected_once - w.reflected_more);
          if (eta > 1) {
            worst_in = std::max(worst_in, off);
          } else {
            worst_any = std::max(worst_any, off);
            if (n == 1.5) worst_out = std::max(worst_out, off);
            squares += off * off;
            ++count;
          }
        }
  constexpr double noise = 4.5 * 0.2 / 141; // the lost part's share has a smaller spread than 0.5
  EXPECT_LT(worst_in, 0.032 + noise);
  EXPECT_LT(worst_out, 0.034 + noise);
  EXPECT_LT(worst_any, 0.14 + noise);
  EXPECT_LT(std::sqrt(squares / count),
            0.045); // 0.021 over a dense set; these corners are the harder ones
}

TEST(multiple_scattering, metals_follow_the_walk_as_their_header_says) {
  for (double alpha : {0.2, 0.5, 1.0}) {
    double e_avg = 0;
    const Rule rule = gauss_legendre(8, 0, 1);
    for (std::size_t i = 0; i < rule.x.size(); ++i)
      e_avg += 2 * rule.w[i] * rule.x[i]
               * lossless_albedo(std::acos(rule.x[i]), alpha, Smith::correlated);
    for (double theta : {0.0, 60.0, 80.0})
      for (double f : {0.5, 0.9}) {
        const double e = lossless_albedo(theta * degree, alpha, Smith::correlated);
        const double model = f * e + (1 - e) * f64::multipleFresnel(f, e_avg);
        const double walk = walk_mirror(std::cos(theta * degree), alpha, f, walks, seed);
        EXPECT_NEAR(model, walk, (alpha < 1 ? 0.012 : 0.033) + walk_error / 2)
            << alpha << " " << theta << " " << f;
      }
  }
}

} // namespace
} // namespace gg::bsdf_test
