// The gaussians of what an interface transmits: against first-order theory, against new fits, and between the nodes.
#include "tables/lookup.h"
#include "tables/make_interface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace gg::tables {
namespace {

namespace f64 = gg::glsl::f64;
constexpr double degree = 0.017453292519943295;

const FitViews& views() {
  static const FitViews made = make_fit_views(nullptr);
  return made;
}

GaussianSum stored_lobes(const Model& model, int gaussians, const InterfaceAxes& at) {
  GaussianSum set;
  for (int k = 0; k < gaussians; ++k) {
    const auto t = interface_lobe_at(model, k, gaussians, at.cos_theta, at.alpha, at.eta);
    set.push_back({t.angle, t.sigma, t.weight});
  }
  return set;
}

// A facet that leans by t turns the ray by |cos_t - cos_i / eta| t: the lobe is alpha times that across the plane of
// incidence, 1 / cos_t times as wide within it. The one Gaussian that does best for
// GGX's lobe, with its far tail, is 1.5 times as wide.
TEST(interface_lobes, of_small_alpha_are_where_and_as_wide_as_first_order_theory_says) {
  constexpr double alpha = 0.02, shape = 1.5;
  for (double eta : {1.2, 1.5, 2.0, 1.0 / 1.2, 1.0 / 1.5, 1.0 / 2.0})
    for (double angle : {0.0, 15.0, 25.0}) {
      const double c = std::cos(angle * degree), cos_t = f64::fresnelG(c, eta) / eta;
      if (eta < 1.0 && cos_t < 0.7) continue; // near the critical angle the second order rules
      const double width = std::abs(cos_t - c / eta) * alpha / std::sqrt(cos_t);
      const auto gaussian = interface_lobe_at(models[0], 0, 1, c, alpha, eta);
      EXPECT_NEAR(gaussian.angle, f64::interfaceSnell(c, eta), 0.1 * width) << eta << ' ' << angle;
      EXPECT_NEAR(gaussian.sigma / width, shape, 0.12) << eta << ' ' << angle;
      EXPECT_NEAR(gaussian.weight, 1.0, 1e-12);
    }
}

TEST(interface_lobes, at_normal_incidence_point_along_the_normal) {
  for (const Model& model : models)
    for (int gaussians : {1, 2})
      for (int k = 0; k < gaussians; ++k)
        for (double eta : {1.5, 0.6})
          EXPECT_NEAR(interface_lobe_at(model, k, gaussians, 1.0, 0.3, eta).angle, 0.0, 1e-9);
}

TEST(interface_lobes, of_index_one_turn_nothing) {
  for (double c : {0.2, 0.9}) {
    const auto gaussian = interface_lobe_at(models[0], 0, 1, c, 0.4, 1.0);
    EXPECT_NEAR(gaussian.angle, std::acos(c), 1e-9);
    EXPECT_EQ(gaussian.sigma, 0.0);
  }
}

TEST(interface_lobes, have_weights_that_sum_to_one_and_the_core_first) {
  for (const Model& model : models)
    for (int gaussians = 1; gaussians <= lobes_of(model); ++gaussians)
      for (double eta : {3.0, 1.5, 1.05, 0.95, 0.66, 0.3})
        for (double alpha : {0.003, 0.1, 0.5, 1.0})
          for (double c : {0.01, 0.3, 0.6, 0.9, 1.0}) {
            double sum = 0.0, sigma = 0.0;
            for (int k = 0; k < gaussians; ++k) {
              const auto t = interface_lobe_at(model, k, gaussians, c, alpha, eta);
              sum += t.weight;
              EXPECT_GE(t.sigma, 0.998 * sigma); // halves
              EXPECT_LT(t.sigma, 1.3);
              sigma = t.sigma;
            }
            EXPECT_NEAR(sum, 1.0, 2e-3) << name(model) << ' ' << gaussians; // of halves
          }
}

// Cells of all kinds: entering, leaving within and past the critical angle.
struct Node {
  int x, y, slice;
};
constexpr Node nodes[] = {{6, 5, 3},   {20, 9, 4},   {12, 7, 8},
                          {22, 6, 17}, {16, 10, 15}, {9, 11, 17}};

TEST(interface_lobes, are_fitted_again_as_well_and_to_the_same_place) {
  for (int gaussians = 1; gaussians <= 4; ++gaussians)
    for (const Node& n : nodes) {
      const GridCell cell = interface_cell(views(), models[0], n.x, n.y, n.slice);
      const GaussianSum kept =
          stored_lobes(models[0], gaussians, interface_lobe_axes(n.x, n.y, n.slice));
      const FitResult again = fit_from_scratch(views(), cell.target, gaussians, 40);
      const double stored = log_error(views(), cell.target, kept);
      const FitResult moved = fit(views(), cell.target, kept, 10, kept);
      double distance = 0.0;
      for (std::size_t k = 0; k < kept.size(); ++k)
        distance = std::max(
            distance,
            std::max(std::abs(moved.gaussians[k].angle - kept[k].angle) / cell.target.width,
                     std::abs(std::log(moved.gaussians[k].sigma / kept[k].sigma))));
      std::printf(
          "    %d gaussians, node %2d %2d %2d: stored %.4f, fitted again %.4f, moves by %.3f\n",
          gaussians, n.x, n.y, n.slice, stored, again.error, distance);
      // Pulled towards its neighbours a fit gives up a little; a flat minimum moves without gain.
      EXPECT_LT(stored, 1.1 * again.error + 0.005);
      EXPECT_LT(distance, 0.25);
    }
}

// What interpolation costs: half-way between nodes along all axes, beside a fit at that very place.
TEST(interface_lobes, between_nodes_are_nearly_as_good_as_a_fit_there) {
  for (int gaussians : {1, 2, 4}) {
    double table_squares = 0.0, fit_squares = 0.0;
    int count = 0;
    for (const Node& n : nodes) {
      const InterfaceAxes a = interface_lobe_axes(n.x, n.y, n.slice),
                          b = interface_lobe_axes(n.x + 1, n.y + 1, n.slice + 1);
      const double eta = std::sqrt(a.eta * b.eta),
                   c = f64::interfaceCosineAt((n.x + 0.5) / (f64::INTERFACE_LOBE_COSINES - 1), eta),
                   alpha = std::pow(0.5 * (std::sqrt(a.alpha) + std::sqrt(b.alpha)), 2.0);
      const std::vector<LobeSample> lobe = transmission_lobe(models[0], alpha, c, eta, 768);
      std::vector<double> weights;
      for (const LobeSample& s : lobe)
        weights.push_back(s.weight);
      const FitTarget target = fit_target(views(), lobe, weights, false);
      const double table =
          log_error(views(), target, stored_lobes(models[0], gaussians, {c, alpha, eta}));
      const double here = fit_from_scratch(views(), target, gaussians, 40).error;
      table_squares += table * table;
      fit_squares += here * here;
      ++count;
    }
    const double table = std::sqrt(table_squares / count), here = std::sqrt(fit_squares / count);
    std::printf("    %d gaussians: from the table %.4f, fitted there %.4f\n", gaussians, table,
                here);
    EXPECT_LT(table, 1.15 * here + 0.005);
  }
}

} // namespace
} // namespace gg::tables
