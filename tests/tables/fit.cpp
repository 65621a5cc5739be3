// How near one and two Gaussians come to lobes on environments that no fit has seen, beside the usual approximation.
#include "tables/lookup.h"
#include "tables/proof.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace gg::tables {
namespace {

const Training& maps() {
  static const Training training = held_out_maps(128, 8);
  return training;
}

void print(const char* what, const Model& model, const Scores& s) {
  std::printf("    %-20s %-10s standard %.3f  fis32 %.3f  gaussians", name(model).c_str(), what,
              s.rms("standard"), s.rms("fis32"));
  for (int k = 1; k <= lobes_of(model); ++k)
    std::printf(" %.3f", s.rms("lobes" + std::to_string(k)));
  std::printf("\n");
}

TEST(gaussians, are_nearer_to_reflection_than_the_split_sum) {
  for (const Model& model : models) {
    const Scores s = score(maps(), model, Side::reflection, short_sweep());
    print("reflected", model, s);
    // One Gaussian has not the far tail that GGX has, and its prefiltered map with it.
    EXPECT_GT(s.gain("lobes1"), 1.05) << name(model);
    EXPECT_GT(s.gain("lobes2"), 2.2) << name(model);
  }
}

TEST(gaussians, are_nearer_to_transmission_than_roughness_scaled_by_index) {
  for (const Model& model : models)
    for (Side side : {Side::entering, Side::leaving}) {
      const Scores s = score(maps(), model, side, short_sweep());
      print(side == Side::entering ? "entering" : "leaving", model, s);
      EXPECT_GT(s.gain("lobes1"), 2.0) << name(model);
      EXPECT_GT(s.gain("lobes2"), 3.0) << name(model);
    }
}

// A dielectric's edge leans its lobe towards grazing facets: the metal's gaussian is another.
TEST(gaussians, of_reflection_need_their_axis_for_the_fresnel_edge) {
  constexpr double edge = 0.5;
  double own = 0.0, metal = 0.0;
  for (double alpha : {0.1, 0.35, 0.8})
    for (double c : {1.0, 0.75, 0.5, 0.2}) {
      const std::vector<LobeSample> lobe =
          reflection_lobe(models[0], alpha, c, Walk::lattice, 1024);
      double flat_sum = 0.0, edge_sum = 0.0;
      for (const LobeSample& s : lobe) {
        flat_sum += s.weight;
        edge_sum += s.weight * glsl::f64::schlickWeight(s.cos_facet);
      }
      std::vector<double> weights;
      for (const LobeSample& s : lobe)
        weights.push_back(
            s.weight
            * ((1.0 - edge) / flat_sum + edge * glsl::f64::schlickWeight(s.cos_facet) / edge_sum));
      const std::vector<double> truth = radiance(maps(), lobe, weights);
      const glsl::f64::vec3 n(0, 0, 1), mirror(-std::sqrt(1.0 - c * c), 0.0, c);
      const auto error = [&](double share) {
        const auto t = reflection_texel_at(models[0], 0, 1, c, alpha, share);
        return log_error(maps(), truth,
                         {{glsl::f64::lobeDirection(mirror, n, t[0]), t[1] * alpha, 1.0}});
      };
      own += error(edge) * error(edge);
      metal += error(0.0) * error(0.0);
    }
  std::printf("    half from the edge: one gaussian %.3f  the metal's gaussian %.3f\n",
              std::sqrt(own / 12), std::sqrt(metal / 12));
  EXPECT_LT(own, metal);
}

} // namespace
} // namespace gg::tables
