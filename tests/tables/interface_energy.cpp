// Energies through and back from an interface: what shaders look up, against quadratures that share no code with the tables.
#include "bsdf/quadrature.h"
#include "tables/lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace gg::tables {
namespace {

namespace f64 = gg::glsl::f64;
constexpr double degree = 0.017453292519943295;

// Off the nodes in every axis. 45 and 80 degrees are past the critical angle of 1.5 and 1.9.
constexpr double angles[] = {0.0, 20.0, 45.0, 62.0, 80.0}, alphas[] = {0.06, 0.15, 0.33, 0.7},
                 indices[] = {1.15, 1.5, 1.9, 2.7};

// What linear interpolation may cost: the most, and on average. Measured below and printed.
constexpr double worst_allowed = 0.025, rms_allowed = 0.004;

struct Worst {
  double squares = 0.0, most = 0.0;
  int count = 0;
  void add(double error) {
    squares += error * error;
    most = std::max(most, std::abs(error));
    ++count;
  }
  double rms() const { return std::sqrt(squares / count); }
};

TEST(interface_energy, of_ggx_agrees_with_the_quadrature_over_visible_normals) {
  for (Smith smith : {Smith::separable, Smith::correlated}) {
    const auto exact_smith =
        smith == Smith::separable ? bsdf_test::Smith::separable : bsdf_test::Smith::correlated;
    const Model model{Distribution::ggx, smith};
    Worst through, back;
    for (double index : indices)
      for (double eta : {index, 1.0 / index})
        for (double alpha : alphas)
          for (double angle : angles) {
            const bsdf_test::Energy exact =
                bsdf_test::single_scattering(angle * degree, alpha, eta, exact_smith);
            const auto table = interface_energy_at(model, std::cos(angle * degree), alpha, eta);
            through.add(table.transmitted - exact.transmitted);
            back.add(table.reflected - exact.reflected);
          }
    std::printf("    %-20s transmitted: worst %.4f rms %.4f  reflected: worst %.4f rms %.4f\n",
                name(model).c_str(), through.most, through.rms(), back.most, back.rms());
    EXPECT_LT(through.most, worst_allowed + bsdf_test::grid_error);
    EXPECT_LT(back.most, worst_allowed + bsdf_test::grid_error);
    EXPECT_LT(through.rms(), rms_allowed);
    EXPECT_LT(back.rms(), rms_allowed);
  }
}

// Over facets: T = integral of 4 V |wi . n| D (wo . wm) (1 - F).
TEST(interface_energy, of_beckmann_agrees_with_the_quadrature_over_facets) {
  const Model model{Distribution::beckmann, Smith::separable};
  Worst through;
  for (double eta : {1.5, 1.0 / 1.5, 1.0 / 1.9})
    for (double alpha : {0.15, 0.33, 0.7})
      for (double angle : angles) {
        const bsdf_test::Distribution d = bsdf_test::beckmann(alpha);
        const f64::vec3 wo = bsdf_test::direction(angle * degree, 0.0);
        const double exact = bsdf_test::integrate_about_normal(alpha, 160, 240, [&](f64::vec3 m) {
          const double facing = f64::dot(wo, m);
          if (!(facing > 0.0)) return 0.0;
          const f64::vec3 wi = f64::refractAbout(wo, m, eta);
          if (!(wi.z < 0.0)) return 0.0;
          return 4.0 * d.v(f64::tilt(wi), f64::tilt(wo)) * -wi.z * d.d(f64::tilt(m)) * facing
                 * f64::fresnelTransmittedAt(facing, eta);
        });
        through.add(interface_energy_at(model, wo.z, alpha, eta).transmitted - exact);
      }
  std::printf("    %-20s transmitted: worst %.4f rms %.4f\n", name(model).c_str(), through.most,
              through.rms());
  EXPECT_LT(through.most, worst_allowed);
  EXPECT_LT(through.rms(),
            1.5 * rms_allowed); // fewer points, and more of them past the critical angle
}

TEST(interface_energy, of_smooth_glass_is_fresnel_s) {
  for (double eta : {1.5, 1.0 / 1.5})
    for (double c : {1.0, 0.8, 0.5, 0.2}) {
      const auto e = interface_energy_at(models[0], c, 0.0, eta);
      EXPECT_NEAR(e.transmitted, f64::fresnelTransmittedAt(c, eta), 0.01) << eta << ' ' << c;
      EXPECT_NEAR(e.transmitted + e.reflected, 1.0, 1e-3) << eta << ' ' << c; // halves
    }
}

// Narrow lobes change within a facet's lean of the critical angle and of the surface, between two nodes: there, and between two
// indices, the table is at its worst.
TEST(interface_energy, of_narrow_lobes_is_worst_and_that_is_bounded) {
  constexpr double worst_narrow = 0.045, rms_narrow = 0.004;
  constexpr int count = 48;
  Worst through, back;
  for (double eta : {1.33, 1.5, 1.0 / 1.33, 1.0 / 1.5, 1.0 / 1.9})
    for (double alpha : {0.0005, 0.002, 0.005, 0.012, 0.02, 0.03, 0.045})
      for (int i = 0; i < count; ++i) {
        const double c = std::pow((i + 0.37) / count, 1.5);
        const InterfaceShares exact = interface_shares(models[0], alpha, c, eta, 48);
        const auto read = interface_energy_at(models[0], c, alpha, eta);
        through.add(read.transmitted - exact.transmitted);
        back.add(read.reflected - exact.reflected);
      }
  std::printf(
      "    alpha below .05: transmitted: worst %.4f rms %.4f  reflected: worst %.4f rms %.4f\n",
      through.most, through.rms(), back.most, back.rms());
  EXPECT_LT(std::max(through.most, back.most), worst_narrow);
  EXPECT_LT(std::max(through.rms(), back.rms()), rms_narrow);
}

TEST(interface_energy, is_never_gained) {
  for (const Model& model : models) {
    if (model.distribution == Distribution::phong)
      continue; // it does gain: shaders/bsdf/phong.glsl
    double most = 0.0;
    for (double eta : {4.0, 2.0, 1.5, 1.1, 1.0, 0.9, 0.7, 0.4, 0.25})
      for (double alpha = 0.0; alpha <= 1.0; alpha += 0.05)
        for (double c = 0.0; c <= 1.0; c += 0.02) {
          const auto e = interface_energy_at(model, c, alpha, eta);
          EXPECT_GE(std::min(e.transmitted, e.reflected), 0.0);
          most = std::max(most, e.transmitted + e.reflected);
        }
    EXPECT_LT(most, 1.004) << name(model); // Beckmann's rational G1 is off by as much
  }
}

} // namespace
} // namespace gg::tables
