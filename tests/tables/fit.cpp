// How near one Gaussian comes to the lobe on environments that no fit has seen, beside what peers do.
#include "tables/gaussian_fit.h"
#include "tables/lookup.h"
#include "tables/training_maps.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace gg::tables {
namespace {

const Training& held_out() {
  static const Training training = [] {
    std::vector<SphereStack> stacks;
    for (int draw : held_out_draws)
      for (const TrainingMap& map : training_maps(128, draw))
        stacks.emplace_back(map.map);
    return Training(std::move(stacks), 32, 2);
  }();
  return training;
}

struct Errors {
  double one_tap = 0.0, standard = 0.0, metals_table = 0.0;
};
Errors errors(const Model& model, double edge) {
  Errors sum;
  int count = 0;
  for (double alpha : {0.05, 0.1, 0.2, 0.35, 0.5, 0.8})
    for (double c : {1.0, 0.9, 0.75, 0.5, 0.3, 0.12}) {
      const LobeRadiance truth =
          lobe_radiance(held_out(), reflection_lobe(model, alpha, c, Walk::lattice, 1024));
      const auto rms = [&](const std::array<double, 4>& texel, bool mirror) {
        return log_error(held_out(), truth, edge, c, {mirror ? 0.0 : texel[0], texel[1] * alpha});
      };
      const double a = rms(tap_at(model, c, alpha, edge), false),
                   b = rms(tap_at(model, 1.0, alpha, 0.0), true),
                   m = rms(tap_at(model, c, alpha, 0.0), false);
      sum.one_tap += a * a;
      sum.standard += b * b;
      sum.metals_table += m * m;
      ++count;
    }
  return {std::sqrt(sum.one_tap / count), std::sqrt(sum.standard / count),
          std::sqrt(sum.metals_table / count)};
}

TEST(one_tap, beats_the_split_sum_along_the_mirror_direction) {
  for (const Model& model : models) {
    const Errors e = errors(model, 0.0);
    std::printf("    %-20s metal       one tap %.3f  standard %.3f\n", name(model).c_str(),
                e.one_tap, e.standard);
    EXPECT_LT(e.one_tap, 0.75 * e.standard) << name(model);
  }
}

TEST(one_tap, needs_its_axis_for_the_fresnel_edge) {
  const Errors e = errors(models[0], 0.5);
  std::printf("    half from the edge: one tap %.3f  the metal's tap %.3f  standard %.3f\n",
              e.one_tap, e.metals_table, e.standard);
  EXPECT_LT(e.one_tap, e.metals_table);
  EXPECT_LT(e.one_tap, e.standard);
}

} // namespace
} // namespace gg::tables
