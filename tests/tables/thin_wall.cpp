// Thin walls: the tables against longer walks, against smooth panes, and against what the energy study found.
#include "tables/thin_wall.h"

#include "core/files.h"
#include "glsl/f64.h"
#include "tables/lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gg::tables {
namespace {

namespace f64 = gg::glsl::f64;
constexpr double degree = 0.017453292519943295;

f64::vec4 texel(const ThinWallTable& table, int lobe, double c, double alpha, double eta) {
  const int lobes = std::max(table.lobes, 1);
  const f64::vec3 u = f64::thinWallCoordinate(lobe, lobes, c, alpha, eta);
  const auto t = lookup<3>(
      table.texels, {f64::THIN_WALL_COSINES, f64::THIN_WALL_ALPHAS * lobes, f64::THIN_WALL_SLICES},
      {u.x, u.y, u.z});
  return {t[0], t[1], t[2], t[3]};
}

ThinWallTable stored(const Model& model, int lobes) {
  return read_thin_wall(home_directory() / "assets" / "tables", model, lobes);
}

TEST(thin_wall, smooth_panes_pass_what_all_orders_of_reflection_leave) {
  const ThinWallTable table = stored(models[0], 0);
  for (double c : {1.0, 0.7, 0.4}) {
    const double f = f64::fresnelDielectricAt(c, 1.5);
    const auto e = f64::thinWallEnergy(texel(table, 0, c, 0.0, 1.5));
    EXPECT_NEAR(e.transmitted, (1.0 - f) / (1.0 + f), 0.01) << c; // of interpolation
    EXPECT_NEAR(e.reflectedFirst, f, 0.01) << c;
    EXPECT_NEAR(e.transmitted + e.reflectedFirst + e.reflectedLater, 1.0, 1e-3)
        << c; // of half floats
  }
}

TEST(thin_wall, of_alpha_a_fifth_passes_what_the_energy_study_walked) {
  const ThinWallTable table = stored(models[0], 0);
  constexpr double read_off = 0.02; // two digits there, interpolation here
  for (const auto& [angle, passed] :
       {std::pair{0.0, 0.87}, {55.0, 0.62}, {70.0, 0.41}, {82.0, 0.26}}) {
    const auto e = f64::thinWallEnergy(texel(table, 0, std::cos(angle * degree), 0.2, 1.5));
    EXPECT_NEAR(e.transmitted, passed, read_off) << angle;
  }
}

TEST(thin_wall, between_nodes_is_what_longer_walks_find) {
  constexpr double tolerance = 0.02; // of interpolation; the walks are good to 0.004
  for (const Model& model : models) {
    const ThinWallTable table = stored(model, 0);
    for (double eta : {1.3, 1.7})
      for (double alpha : {0.07, 0.3, 0.8})
        for (double angle : {10.0, 50.0, 75.0}) {
          const double c = std::cos(angle * degree);
          const WallLight exact = through_wall(model, alpha, c, eta, 12000);
          const auto e = f64::thinWallEnergy(texel(table, 0, c, alpha, eta));
          EXPECT_NEAR(e.transmitted, exact.transmitted, tolerance) << alpha << ' ' << angle;
          EXPECT_NEAR(e.reflectedFirst, exact.reflected_first, tolerance) << alpha << ' ' << angle;
          EXPECT_NEAR(e.reflectedLater, exact.reflected_later, tolerance) << alpha << ' ' << angle;
          if (model.distribution == Distribution::phong) continue; // gains energy
          EXPECT_LE(exact.transmitted + exact.reflected_first + exact.reflected_later, 1.0)
              << alpha << ' ' << angle;
        }
  }
}

// Beckmann's facets have Gaussian slopes, of variance alpha² / 2 per axis, so that widths are standard deviations.
TEST(thin_wall, what_comes_back_from_within_is_as_much_wider_than_the_mirrors_lobe_as_said) {
  constexpr double alpha = 0.03;      // terms of the next order are alpha², a thousandth
  constexpr double statistics = 0.03; // 12,000 paths
  const Model beckmann{Distribution::beckmann, Smith::separable};
  for (const double eta : {1.3, 1.5, 2.0}) {
    const WallLight light = through_wall(beckmann, alpha, 1.0, eta, 12000);
    double power = 0.0, spread = 0.0;
    for (const LobeSample& s : light.returned) {
      if (s.wi.z < 0.9) continue; // of paths that are reflected more than once, few and wider
      power += s.weight;
      spread += 0.5 * s.weight * (s.wi.x * s.wi.x + s.wi.y * s.wi.y);
    }
    const double mirrors = std::sqrt(2.0) * alpha; // per axis: twice the facets'
    EXPECT_NEAR(std::sqrt(spread / power) / mirrors / f64::thinWallLaterSpread(eta), 1.0,
                statistics)
        << eta;
  }
}

TEST(thin_wall, lobes_go_straight_on_and_are_as_wide_as_both_faces) {
  for (const Model& model : models)
    for (int lobes = 1; lobes <= most_wall_lobes; ++lobes) {
      const ThinWallTable table = stored(model, lobes);
      for (double angle : {0.0, 40.0}) {
        const double c = std::cos(angle * degree);
        double weights = 0.0, mean = 0.0, narrowest = 1.0;
        for (int k = 0; k < lobes; ++k) {
          const auto lobe = f64::thinWallLobe(texel(table, k, c, 0.03, 1.5), c, 0.03, 1.5);
          narrowest = std::min(narrowest, lobe.sigma);
          mean += lobe.weight * lobe.angle;
          EXPECT_GT(lobe.sigma, 0.3 * f64::thinWallWidth(c, 0.03, 1.5));
          EXPECT_LT(lobe.sigma, 12.0 * f64::thinWallWidth(c, 0.03, 1.5));
          weights += lobe.weight;
        }
        // Lobes without a tail are two lobes side by side, as they are longer in the plane of incidence than across it.
        EXPECT_NEAR(mean, angle * degree, 0.5 * narrowest) << angle;
        EXPECT_NEAR(weights, 1.0, 2e-3);
      }
    }
}

} // namespace
} // namespace gg::tables
