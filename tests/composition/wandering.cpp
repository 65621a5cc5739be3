// Light that wanders in a solid: what gets out, against the tables of a face's energy.
#include "glsl/f64.h"
#include "tables/lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gg::composition_test {
namespace {

namespace f64 = gg::glsl::f64;

// Midpoints in sin², by which isotropic light comes: the square root at the critical angle leaves 1e-4.
constexpr int nodes = 2000;

// Transmitted / (transmitted + lost) of isotropic light, by the table.
double escapes_by_table(const tables::Model& model, double alpha, double ior) {
  double transmitted = 0.0, lost = 0.0;
  for (int i = 0; i < nodes; ++i) {
    const double cosine = std::sqrt((i + 0.5) / nodes);
    const auto e = tables::interface_energy_at(model, cosine, alpha, 1.0 / ior);
    transmitted += e.transmitted / nodes;
    lost += (1.0 - e.transmitted - e.reflected) / nodes;
  }
  return transmitted / (transmitted + lost);
}

double largest_error(const tables::Model& model, const f64::WanderingLoss& loss) {
  double largest = 0.0;
  for (double ior : {1.1, 1.2, 1.33, 1.5, 1.8, 2.2, 2.6})
    for (double alpha : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.0})
      largest = std::max(largest, std::abs(f64::wanderingEscapes(alpha, ior, loss)
                                           - escapes_by_table(model, alpha, ior)));
  std::printf("    largest error of the share that gets out %.3f\n", largest);
  return largest;
}

} // namespace

TEST(wandering_light, gets_out_as_the_tables_of_energy_say) {
  EXPECT_LT(largest_error(tables::models[0], f64::wanderingLossGgx()), 0.025);
  EXPECT_LT(largest_error(tables::models[2], f64::wanderingLossBeckmann()), 0.04);
  EXPECT_LT(largest_error(tables::models[3], f64::wanderingLossBeckmann()), 0.16);
}

// With the constants of separable masking.
TEST(wandering_light, gets_out_with_correlated_masking_too) {
  EXPECT_LT(largest_error(tables::models[1], f64::wanderingLossGgx()), 0.07);
}

// [Walter07]'s n² of radiance: Egan and Hilgeman's 1 - .596 for 1.5.
TEST(wandering_light, passes_a_smooth_face_as_fresnel_and_reciprocity_say) {
  EXPECT_NEAR(f64::wanderingPasses(1.5), 1.0 - 0.596, 0.004); // two nodes
  EXPECT_NEAR(f64::wanderingPasses(1.5), f64::wanderingPasses(1.0 / 1.5) / (1.5 * 1.5), 1e-12);
  EXPECT_EQ(f64::wanderingPasses(1.0), 1.0);
  for (double ior : {0.25, 0.7, 1.0, 1.5, 4.0}) {
    EXPECT_EQ(f64::wanderingEscapes(0.0, ior, f64::wanderingLossGgx()), 1.0);
    for (double alpha : {0.3, 1.0})
      for (const auto& loss : {f64::wanderingLossGgx(), f64::wanderingLossBeckmann()}) {
        const double escapes = f64::wanderingEscapes(alpha, ior, loss);
        EXPECT_GT(escapes, 0.0);
        EXPECT_LE(escapes, 1.0);
      }
  }
}

// Half of it meets the body again and half of that gets out once more, and so on.
TEST(wandering_light, that_meets_the_body_again_is_out_when_it_is_out_for_good) {
  double sum = 0.0, left = 1.0;
  for (int k = 0; k < 60; ++k) {
    sum += left * 0.8 * 0.5;
    left *= 0.8 * 0.5;
  }
  EXPECT_NEAR(f64::wanderingLeaves(0.8, 0.5), sum, 1e-12);
  EXPECT_EQ(f64::wanderingLeaves(1.0, 0.5), 1.0);
}

} // namespace gg::composition_test
