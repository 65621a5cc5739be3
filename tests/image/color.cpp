// The colour snippets, as the C++ that is made from their text.
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace f64 = gg::glsl::f64;
namespace f32 = gg::glsl::f32;
using f64::vec3;

namespace {

constexpr double rounding = 1e-12; // of a few dozen operations in double

vec3 curve(int which, const vec3& c) {
  return which == 0   ? f64::tonemapNeutral(c)
         : which == 1 ? f64::tonemapAces(c)
                      : f64::tonemapAgx(c);
}

void expect_near(const vec3& a, const vec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

} // namespace

TEST(srgb, has_the_standards_values_and_inverse) {
  EXPECT_NEAR(f64::linearFromSrgb(0.5), 0.21404114048223255, rounding);
  EXPECT_NEAR(f64::srgbFromLinear(0.18), 0.46135612950044164, rounding);
  EXPECT_EQ(f64::srgbFromLinear(-3.0), 0.0);
  EXPECT_NEAR(f64::srgbFromLinear(INFINITY), 1.0, rounding);
  constexpr double joint = 1.3e-8 * 12.92; // how badly the two pieces meet, in encoded values
  for (int i = 0; i <= 1000; ++i)
    EXPECT_NEAR(f64::srgbFromLinear(f64::linearFromSrgb(i / 1000.0)), i / 1000.0, joint);
  const double below = 0.0031308, above = std::nextafter(below, 1.0);
  EXPECT_LT(std::abs(f64::srgbFromLinear(above) - f64::srgbFromLinear(below)), 1.3e-8 * 12.92);
}

TEST(tonemap, known_values) {
  // Neutral below its knee: 4 % taken from each channel, less where the darkest is below 8 %.
  expect_near(f64::tonemapNeutral(vec3(0.5, 0.3, 0.2)), vec3(0.46, 0.26, 0.16), rounding);
  expect_near(f64::tonemapNeutral(vec3(0.5, 0.3, 0.04)), vec3(0.47, 0.27, 0.01), rounding);
  // Above, for grey: 1 - 0.24^2 / (1.96 - 0.76 + 0.24).
  expect_near(f64::tonemapNeutral(vec3(2.0)), vec3(0.96), rounding);
  // The rational fit for grey, by hand; the matrices' rows add up to 1 but for their 5 digits.
  const double fit = 0.18 * (0.18 + 0.0245786) - 0.000090537;
  const double under = 0.18 * (0.983729 * 0.18 + 0.4329510) + 0.238081;
  expect_near(f64::tonemapAces(vec3(0.18)), vec3(fit / under), 5e-5);
  // Middle grey is the curve's pivot: half the encoded range, on a 2.2 display.
  expect_near(f64::tonemapAgx(vec3(0.18)), vec3(std::pow(0.5, 2.2)), 1e-4);
  EXPECT_NEAR(f64::tonemapAgxCurve(0.0), 0.0, rounding);
  EXPECT_NEAR(f64::tonemapAgxCurve(1.0), 1.0, rounding);
}

TEST(tonemap, agx_is_the_curve_that_its_polynomial_approximates) {
  // B. Wrensch's sixth-order fit of the same sigmoid, mean squared error 3.67e-6: independent of
  // ours.
  double sum = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0;
    const double fit =
        ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x)
        - 0.00232;
    sum += std::pow(f64::tonemapAgxCurve(x) - fit, 2.0);
  }
  EXPECT_LT(std::sqrt(sum / 1001.0), 0.003);
}

TEST(tonemap, grey_stays_grey_and_brighter_is_not_darker) {
  for (int which = 0; which < 3; ++which) {
    double last = 0.0;
    for (double v = 1e-6; v < 1e6; v *= 1.1) {
      const vec3 c = curve(which, vec3(v));
      // The 5-digit matrices of Aces tint by this much at most.
      expect_near(c, vec3(c.x), which == 1 ? 2e-4 : 1e-3 * (which == 2) + rounding);
      EXPECT_GE(c.x, last - rounding) << which << " " << v;
      last = c.x;
    }
    EXPECT_NEAR(last, 1.0, 1e-3) << which;
  }
}

TEST(tonemap, every_input_lands_in_the_display) {
  std::mt19937 random(7u);
  const std::vector<double> hard{0.0, -1.0, 1e-300, 1e300, INFINITY, -INFINITY};
  const auto pick = [&] {
    const auto r = random();
    return r % 4 == 0 ? hard[r / 4 % hard.size()] : std::exp2(static_cast<double>(r % 60) - 30.0);
  };
  for (int i = 0; i < 20000; ++i) {
    const vec3 in(pick(), pick(), pick());
    for (int which = 0; which < 3; ++which) {
      const vec3 out = curve(which, in);
      for (int c = 0; c < 3; ++c)
        ASSERT_TRUE(out[c] >= 0.0 && out[c] <= 1.0)
            << which << ": " << in.x << " " << in.y << " " << in.z << " -> " << out[c];
    }
  }
}

TEST(tonemap, single_precision_agrees_to_a_tenth_of_an_8_bit_step) {
  std::mt19937 random(8u);
  for (int i = 0; i < 2000; ++i) {
    float v[3];
    for (float& x : v)
      x = std::exp2(static_cast<float>(random() % 3000) / 100.0f - 15.0f);
    for (int which = 0; which < 3; ++which) {
      const vec3 exact = curve(which, vec3(v[0], v[1], v[2]));
      const f32::vec3 in(v[0], v[1], v[2]);
      const f32::vec3 out = which == 0   ? f32::tonemapNeutral(in)
                            : which == 1 ? f32::tonemapAces(in)
                                         : f32::tonemapAgx(in);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(out[c], exact[c], 0.1 / 255.0);
    }
  }
}
