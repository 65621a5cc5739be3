// What half precision (mediump) is good for: the numbers of shaders/README.md, "Half precision".
// The same snippet text over a number that rounds to 11 bits after every operation.
// `--gtest_filter='half.*'` prints the table.
#include "bsdf/half.h"

#include "glsl/f64.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace half_precision {
using Real = gg::bsdf_test::Half;
#include "glsl/shim.inl"
#include "glsl_generated/half.inl"
} // namespace half_precision

namespace {

namespace f16 = half_precision;
namespace f64 = gg::glsl::f64;
using gg::bsdf_test::Half;
using gg::bsdf_test::round_to_half;

f16::vec3 halves(f64::vec3 v) {
  return {Half(v.x), Half(v.y), Half(v.z)};
}
f64::vec3 doubles(f16::vec3 v) {
  return {double(v.x), double(v.y), double(v.z)};
}

struct Errors {
  double median = 0, p90 = 0;
  double lost =
      0; // share of answers that are 0, infinite or NaN where the truth is an ordinary number
};

Errors summary(std::vector<double> errors, int lost) {
  std::ranges::sort(errors);
  const double total = double(errors.size()) + lost;
  if (errors.empty()) return {1, 1, 1};
  return {errors[errors.size() / 2], errors[errors.size() * 9 / 10], lost / total};
}

// f of a dielectric of index 1.5 at facets drawn from GGX, wo up to 60 degrees. Truth from the
// rounded input, in double.
Errors lobe(double alpha, bool transmits) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> errors;
  int lost = 0;
  for (int i = 0; i < 4000; ++i) {
    const double theta = std::acos(0.5 + 0.5 * uniform(random)),
                 phi = 6.283185307 * uniform(random);
    const f64::vec3 wo(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                       std::cos(theta));
    const double u = uniform(random), v = uniform(random);
    const f64::vec3 m = f64::ggxSample(alpha, f64::vec2(u, v));
    const f16::vec3 o = halves(wo);
    const f16::vec3 w =
        halves(transmits ? f64::refractAbout(wo, m, 1.5) : f64::reflectAbout(wo, m));
    const f16::vec3 n(Half(0.0), Half(0.0), Half(1.0));
    const Half a(alpha), eta(1.5);
    // The compensated facet normalises: half precision directions are unit only to 5e-4, and that
    // is not the formula's fault.
    const f64::vec3 up(0, 0, 1);
    const auto exact = [&] {
      const auto f = transmits ? f64::preciseTransmissionFacet(doubles(w), doubles(o), up, 1.5)
                               : f64::preciseReflectionFacet(doubles(w), doubles(o), up, 1.5);
      const double d = f64::ggxD(f.h, double(a)), g = f64::ggxV(f.wi, f.wo, double(a));
      return transmits ? f64::transmissionF(f, d, g, 1.5) : f64::reflectionF(f, d, g, 1.5);
    }();
    const auto f =
        transmits ? f16::transmissionFacet(w, o, n, eta) : f16::reflectionFacet(w, o, n, eta);
    const Half d = f16::ggxD(f.h, a), g = f16::ggxV(f.wi, f.wo, a);
    const double value =
        double(transmits ? f16::transmissionF(f, d, g, eta) : f16::reflectionF(f, d, g, eta));
    if (!(exact > 1e-3)) continue; // halves end at 6e-8, and lose digits from 6e-5 on
    if (!(value > 0) || std::isinf(value))
      ++lost;
    else
      errors.push_back(std::abs(value / exact - 1));
  }
  return summary(errors, lost);
}

TEST(half, rounds_to_eleven_bits) {
  EXPECT_EQ(round_to_half(1.0F + 1.0F / 4096), 1.0F);
  EXPECT_EQ(round_to_half(1.0F + 1.0F / 1024), 1.0F + 1.0F / 1024);
  EXPECT_EQ(round_to_half(1.0F + 3.0F / 2048), 1.0F + 2.0F / 1024); // a tie, to even
  EXPECT_EQ(round_to_half(65504.0F), 65504.0F);
  EXPECT_TRUE(std::isinf(round_to_half(65520.0F)));
  EXPECT_EQ(round_to_half(5.9604645e-8F), 5.9604645e-8F); // the smallest
  EXPECT_EQ(round_to_half(2e-8F), 0.0F);
}

TEST(half, loses_what_the_readme_says) {
  std::printf(
      "GGX in half precision, relative error of f (median, 90th percentile) and share lost\n");
  std::printf("%8s  %-28s  %-28s\n", "alpha", "reflection", "transmission, eta 1.5");
  double reflection_median_at_half = 0, reflection_median_at_narrow = 0;
  for (double alpha : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.003, 0.001}) {
    const Errors r = lobe(alpha, false), t = lobe(alpha, true);
    std::printf("%8g  %8.2g %8.2g %8.2g   %8.2g %8.2g %8.2g\n", alpha, r.median, r.p90, r.lost,
                t.median, t.p90, t.lost);
    if (alpha == 0.5) reflection_median_at_half = r.median;
    if (alpha == 0.003) reflection_median_at_narrow = std::max(r.median, r.lost);
  }
  EXPECT_LT(reflection_median_at_half, 3e-3);  // three digits, all that the type has
  EXPECT_GT(reflection_median_at_narrow, 0.1); // nothing
}

} // namespace
