// The composed lobe beside the usual approximation and beside brute force: a fixed share of the long table (composition_sweep).
#include "composition/configurations.h"
#include "composition/methods.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gg::composition_test {
namespace {

const tables::Model& ggx = tables::models[0];

// The first of these is the measure of all else: numbers of paths are such that their own noise is about a tenth of the
// errors that are bounded (3 % of radiance for shapes, 0.005 for energies).
constexpr int shape_paths = 2048, energy_paths = 1024;
constexpr double energy_noise = 0.005;

std::vector<Configuration> every(std::size_t stride, const tables::Model& model = ggx) {
  const auto all = configurations(model);
  std::vector<Configuration> list;
  for (std::size_t i = 0; i < all.size(); i += stride)
    list.push_back(all[i]);
  return list;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (double v : values)
    sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// Errors of several methods over configurations, dark ones left out.
using Lobes = std::vector<Lookup> (*)(const Configuration&);
std::vector<double> errors(const std::vector<Configuration>& list,
                           const std::vector<Lobes>& methods) {
  environments();
  std::vector<std::vector<double>> all(methods.size(), std::vector<double>(list.size(), -1.0));
  tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
    const Truth truth = brute_force(list[i], shape_paths);
    if (truth.energy < dark) return;
    const auto seen_truth = seen(truth);
    for (std::size_t m = 0; m < methods.size(); ++m)
      all[m][i] = score(truth, seen_truth, methods[m](list[i])).error;
  });
  std::vector<double> result;
  for (auto& method : all) {
    std::erase_if(method, [](double e) { return e < 0.0; });
    result.push_back(rms(method));
  }
  return result;
}

TEST(composed_lobe, is_six_times_nearer_than_standard_practice_with_two_lobes) {
  const auto e = errors(every(15), {[](const auto& c) { return standard_practice(c, false); },
                                    [](const auto& c) {
                                      return composed(c, {1, 1, 0});
                                    },
                                    [](const auto& c) {
                                      return composed(c, {2, 2, 2});
                                    },
                                    [](const auto& c) {
                                      return composed(c, {2, 2, 0});
                                    },
                                    [](const auto& c) { return added_variances(c, 2, true); }});
  std::printf("    standard %.3f  one lobe %.3f  two lobes %.3f  four unmerged %.3f  variances "
              "added %.3f\n",
              e[0], e[1], e[2], e[3], e[4]);
  EXPECT_LT(6.0 * e[2], e[0]);
  EXPECT_LT(4.0 * e[1], e[0]);
  // What merging costs, and what the rule is for.
  EXPECT_LT(e[2], 1.1 * e[3]);
  EXPECT_LT(1.3 * e[2], e[4]);
}

TEST(composed_lobe, knows_how_a_curved_exit_turns) {
  std::vector<Configuration> list;
  for (const Configuration& c : every(1))
    if ((c.solid.family == "sphere" || c.solid.family == "curved") && list.size() < 100)
      list.push_back(c);
  std::vector<Configuration> some;
  for (std::size_t i = 0; i < list.size(); i += 5)
    some.push_back(list[i]);
  const auto e = errors(some, {[](const auto& c) {
                                 return composed(c, {2, 2, 2});
                               },
                               [](const auto& c) {
                                 return composed(c, {2, 2, 2}, {}, false);
                               }});
  std::printf("    with its turn %.3f  without %.3f\n", e[0], e[1]);
  EXPECT_LT(1.2 * e[0], e[1]);
}

void expect_energies(const tables::Model& model) {
  const auto list = every(1, model);
  std::vector<double> through(list.size()), back(list.size());
  tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
    const Truth truth = brute_force(list[i], energy_paths);
    through[i] = energy_of(composed(list[i], {2, 2, 2})) - truth.energy;
    back[i] = reflected_inside(list[i]) - truth.reflected;
  });
  double worst = 0.0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_NEAR(through[i], 0.0, 0.08 + energy_noise) << list[i].label();
    worst = std::max(worst, std::abs(through[i]));
  }
  std::printf("    let through: rms %.4f, largest %.3f; reflected inside: rms %.4f\n", rms(through),
              worst, rms(back));
  EXPECT_LT(rms(through), 0.015);
  EXPECT_LT(rms(back), 0.035); // rays that miss the exit altogether are up to 0.2 of this
}

TEST(composed_lobe, lets_the_right_energy_through_everywhere) {
  expect_energies(ggx);
}
TEST(composed_lobe, lets_the_right_energy_through_with_correlated_masking) {
  expect_energies(tables::models[1]);
}
TEST(composed_lobe, lets_the_right_energy_through_of_beckmanns_surfaces) {
  expect_energies(tables::models[2]);
}

TEST(composed_lobe, holds_for_beckmann_and_correlated_masking) {
  for (const auto& model : {tables::models[1], tables::models[2]}) {
    const auto e =
        errors(every(30, model), {[](const auto& c) { return standard_practice(c, false); },
                                  [](const auto& c) {
                                    return composed(c, {2, 2, 2});
                                  }});
    std::printf("    %s: standard %.3f  two lobes %.3f\n", tables::name(model).c_str(), e[0], e[1]);
    EXPECT_LT(6.0 * e[1], e[0]) << tables::name(model);
  }
}

// The other way round: light in glass, seen through an air bubble.
TEST(composed_lobe, holds_for_bubbles) {
  std::vector<double> energies, shapes, standard;
  for (const Solid& solid : {slab(), sphere(), wedge(15), wedge_out(15)})
    for (double eta : {1.0 / 1.33, 1.0 / 1.5})
      for (double theta : {0.0, 20.0, 35.0})
        for (const auto& [alpha1, alpha2] :
             {std::pair{0.1, 0.1}, {0.25, 0.0}, {0.02, 0.3}, {0.4, 0.4}}) {
          const Configuration c{solid, ggx, alpha1, alpha2, eta, theta};
          const Truth truth = brute_force(c, shape_paths);
          const auto lobes = composed(c, {2, 2, 2});
          energies.push_back(energy_of(lobes) - truth.energy);
          EXPECT_NEAR(energies.back(), 0.0, 0.08 + energy_noise) << c.label();
          if (truth.energy < dark) continue;
          const auto seen_truth = seen(truth);
          shapes.push_back(score(truth, seen_truth, lobes).error);
          standard.push_back(score(truth, seen_truth, standard_practice(c, false)).error);
        }
  std::printf("    energy rms %.4f; two lobes %.3f, standard %.3f\n", rms(energies), rms(shapes),
              rms(standard));
  EXPECT_LT(3.0 * rms(shapes), rms(standard));
}

TEST(composed_lobe, of_a_nearly_smooth_slab_is_fresnels) {
  // 1e-3 of slope changes E by a thousandth; the tables' half floats and their reading as much again.
  for (double eta : {1.33, 1.5, 2.0})
    for (double theta : {0.0, 30.0, 60.0}) {
      const Configuration c{slab(), ggx, 1e-3, 1e-3, eta, theta};
      const double once = f64::fresnelTransmittedAt(c.wo().z, eta);
      const auto lobes = composed(c, {2, 2, 2});
      EXPECT_NEAR(energy_of(lobes), once * once, 0.004) << c.label();
      for (const Lookup& lobe : lobes) {
        EXPECT_GT(dot(lobe.direction, -c.wo()), 0.999) << c.label();
      }
    }
}

// Rough in, nearly smooth out, at the critical angle: the truth is a lobe cut off at the horizon. One lobe is no way out of it.
TEST(composed_lobe, is_three_times_nearer_even_where_it_is_worst) {
  std::vector<Configuration> nearly_dark;
  for (const Configuration& c : every(1))
    if (past_critical(c) > -2.0 && c.alpha2 <= 0.02 && c.alpha1 >= 0.1) nearly_dark.push_back(c);
  const auto e = errors(nearly_dark, {[](const auto& c) { return standard_practice(c, true); },
                                      [](const auto& c) {
                                        return composed(c, {2, 2, 2});
                                      },
                                      [](const auto& c) {
                                        return composed(c, {1, 1, 0});
                                      }});
  std::printf("    %zu configurations near the critical angle, rough in and smooth out: standard "
              "%.3f  two lobes %.3f  one lobe "
              "%.3f\n",
              nearly_dark.size(), e[0], e[1], e[2]);
  EXPECT_LT(3.0 * e[1], e[0]);
  EXPECT_LT(3.0 * e[2], e[0]);
}

} // namespace
} // namespace gg::composition_test
