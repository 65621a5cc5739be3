// Diffuse internal scattering in a solid: what gets out, against the tables of a face's energy.
#include "glsl/f64.h"
#include "tables/lookup.h"

#include <glm/vec3.hpp>
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

double escapes(double alpha, double ior, const f64::InternalScatteringLoss& loss) {
  return f64::internalScatteringEscapes(f64::internalScatteringAt(alpha, ior, loss),
                                        glm::dvec3(1.0))
      .x;
}

double largest_error(const tables::Model& model, const f64::InternalScatteringLoss& loss) {
  double largest = 0.0;
  for (double ior : {1.1, 1.2, 1.33, 1.5, 1.8, 2.2, 2.6})
    for (double alpha : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.0})
      largest = std::max(largest,
                         std::abs(escapes(alpha, ior, loss) - escapes_by_table(model, alpha, ior)));
  std::printf("    largest error of the share that gets out %.3f\n", largest);
  return largest;
}

} // namespace

TEST(internally_scattered_light, gets_out_as_the_tables_of_energy_say) {
  EXPECT_LT(largest_error(tables::models[0], f64::internalScatteringLossGgx()), 0.025);
  EXPECT_LT(largest_error(tables::models[2], f64::internalScatteringLossBeckmann()), 0.045);
  EXPECT_LT(largest_error(tables::models[3], f64::internalScatteringLossBeckmann()), 0.11);
}

// With the constants of separable masking.
TEST(internally_scattered_light, gets_out_with_correlated_masking_too) {
  EXPECT_LT(largest_error(tables::models[1], f64::internalScatteringLossGgx()), 0.07);
}

// [Walter07]'s n² of radiance: Egan and Hilgeman's 1 - .596 for 1.5.
TEST(internally_scattered_light, passes_a_smooth_face_as_fresnel_and_reciprocity_say) {
  EXPECT_NEAR(f64::internalScatteringPasses(1.5), 1.0 - 0.596, 0.004); // two nodes
  EXPECT_NEAR(f64::internalScatteringPasses(1.5),
              f64::internalScatteringPasses(1.0 / 1.5) / (1.5 * 1.5), 1e-12);
  EXPECT_EQ(f64::internalScatteringPasses(1.0), 1.0);
  for (double ior : {0.25, 0.7, 1.0, 1.5, 4.0}) {
    EXPECT_NEAR(escapes(0.0, ior, f64::internalScatteringLossGgx()), 1.0, 1e-12);
    for (double alpha : {0.3, 1.0})
      for (const auto& loss :
           {f64::internalScatteringLossGgx(), f64::internalScatteringLossBeckmann()}) {
        const double share = escapes(alpha, ior, loss);
        EXPECT_GT(share, 0.0);
        EXPECT_LE(share, 1.0 + 1e-12);
      }
  }
}

// Of what sets out, absorption takes a tenth on the way to each face; there half gets out and a third is reflected inside. And of
// what gets out half meets the body again.
TEST(internally_scattered_light, is_out_when_it_is_out_for_good) {
  const f64::InternalScattering at_a_face{0.5, 1.0 / 3.0};
  const auto followed = [](double way, double again) {
    double out = 0.0, left = 1.0;
    for (int k = 0; k < 200; ++k) {
      left *= way;
      out += left * 0.5 * (1.0 - again);
      left *= 1.0 / 3.0 + 0.5 * again;
    }
    return out;
  };
  const auto convex = f64::internalScatteringEscapes(at_a_face, glm::dvec3(0.9, 1.0, 0.0));
  EXPECT_NEAR(convex.x, followed(0.9, 0.0), 1e-12);
  EXPECT_NEAR(convex.y, followed(1.0, 0.0), 1e-12);
  EXPECT_EQ(convex.z, 0.0);
  const auto concave = f64::internalScatteringEscapes(
      f64::internalScatteringConcave(at_a_face, 0.5), glm::dvec3(0.9));
  EXPECT_NEAR(concave.x, followed(0.9, 0.5), 1e-12);
}

} // namespace gg::composition_test
