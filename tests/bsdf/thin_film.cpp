// The film's colours against the sum over the spectrum: Airy's formula with complex phases at each wavelength, and the observer of
// CIE 1931 by the analytic fit of Wyman, Sloan and Shirley (JCGT 2(2), 2013), under equal energy, in Rec.709.
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gg::test {
namespace {

namespace f64 = glsl::f64;
using Complex = std::complex<double>;

double lobe(double nm, double mean, double below, double above) {
  const double t = (nm - mean) * (nm < mean ? below : above);
  return std::exp(-0.5 * t * t);
}

glm::dvec3 observer(double nm) {
  return {1.056 * lobe(nm, 599.8, 0.0264, 0.0323) + 0.362 * lobe(nm, 442.0, 0.0624, 0.0374)
              - 0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
          0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
          1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

// Reflectance of air, film, base at one wavelength, unpolarised [BornWolf99 §7.6, eq. 16].
double airy(double c, double film, double base, double thickness, double nm) {
  const double sin2 = 1.0 - c * c;
  const double cf = std::sqrt(1.0 - sin2 / (film * film)),
               cb = std::sqrt(1.0 - sin2 / (base * base));
  const Complex turn = std::exp(Complex(0.0, 4.0 * std::numbers::pi * film * thickness * cf / nm));
  double sum = 0.0;
  for (const bool parallel : {false, true}) {
    const auto amplitude = [&](double n1, double c1, double n2, double c2) {
      return parallel ? (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2)
                      : (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    };
    const double a = amplitude(1.0, c, film, cf), b = amplitude(film, cf, base, cb);
    sum += std::norm((a + b * turn) / (1.0 + a * b * turn));
  }
  return 0.5 * sum;
}

glm::dvec3 to_rec709(const glm::dvec3& xyz) {
  return glm::dvec3(3.2404542, -0.9692660, 0.0556434) * xyz.x
         + glm::dvec3(-1.5371385, 1.8760108, -0.2040259) * xyz.y
         + glm::dvec3(-0.4985314, 0.0415560, 1.0572252) * xyz.z;
}

glm::dvec3 by_spectrum(double c, double film, double base, double thickness) {
  glm::dvec3 seen(0.0), white(0.0);
  for (double nm = 360.0; nm <= 830.0; nm += 1.0) {
    seen += airy(c, film, base, thickness, nm) * observer(nm);
    white += observer(nm);
  }
  return to_rec709(seen / white) / to_rec709(glm::dvec3(1.0));
}

double farthest(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

} // namespace

TEST(thin_film, has_the_colours_of_an_integral_over_the_spectrum) {
  // What the Gaussians of the sensitivities are off by; the reference may leave [0, 1], where colours are outside of Rec.709.
  constexpr double observer_fit = 0.02;
  double worst = 0.0, squares = 0.0;
  int count = 0;
  for (const double film : {1.2, 1.33, 1.6, 2.0})
    for (const double base : {1.4, 1.5, 1.8, 2.5})
      for (const double thickness : {50.0, 120.0, 250.0, 400.0, 700.0, 1200.0})
        for (const double c : {1.0, 0.8, 0.5, 0.3, 0.15}) {
          const glm::dvec3 ours = f64::filmFresnel(c, film, thickness, glm::dvec3(base));
          const glm::dvec3 all =
              glm::clamp(by_spectrum(c, film, base, thickness), glm::dvec3(0.0), glm::dvec3(1.0));
          const double off = farthest(ours, all);
          worst = std::max(worst, off);
          squares += off * off;
          ++count;
          EXPECT_LT(off, observer_fit)
              << "film " << film << ", base " << base << ", " << thickness << " nm, cos " << c;
        }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("rms", std::to_string(std::sqrt(squares / count)));
}

TEST(thin_film, of_no_thickness_is_the_bare_substrate) {
  constexpr double series = 2e-3; // of the terms that are left out
  for (const double film : {1.1, 1.33, 1.8})
    for (const double base : {1.3, 1.5, 2.0})
      for (const double c : {1.0, 0.7, 0.4})
        EXPECT_NEAR(f64::filmFresnel(c, film, 0.0, glm::dvec3(base)).y,
                    f64::fresnelDielectricAt(c, base), series);
}

TEST(thin_film, of_the_index_of_air_or_of_the_substrate_is_not_there) {
  constexpr double series = 2e-3;
  for (const double c : {1.0, 0.7, 0.4}) {
    const double bare = f64::fresnelDielectricAt(c, 1.5);
    EXPECT_NEAR(f64::filmFresnel(c, 1.0, 400.0, glm::dvec3(1.5)).x, bare, series);
    EXPECT_NEAR(f64::filmFresnel(c, 1.5, 400.0, glm::dvec3(1.5)).x, bare, series);
  }
}

TEST(thin_film, a_quarter_wave_of_the_right_index_takes_the_reflection_away) {
  // sqrt(1.5) on glass, 550 nm: an anti-reflection coating; green is what is left least of.
  const double film = std::sqrt(1.5), thickness = 550.0 / (4.0 * film);
  const glm::dvec3 coated = f64::filmFresnel(1.0, film, thickness, glm::dvec3(1.5));
  EXPECT_LT(coated.y, 0.004);
  EXPECT_LT(coated.y, coated.x);
  EXPECT_LT(coated.y, coated.z);
}

TEST(thin_film, stays_a_reflectance_at_grazing_angles_and_on_mirrors) {
  for (const float c : {0.0f, 1e-6f, 1e-3f, 0.02f, 1.0f})
    for (const float film : {1.0f, 1.3f, 3.0f})
      for (const float f0 : {0.0f, 0.04f, 0.9f, 1.0f})
        for (const float thickness : {0.0f, 1.0f, 400.0f, 1e5f}) {
          const float base = glsl::f32::filmBaseIor(f0);
          const auto f = glsl::f32::filmFresnel(c, film, thickness, glsl::f32::vec3(base));
          EXPECT_TRUE(f.x >= 0.0f && f.x <= 1.0f && f.y >= 0.0f && f.y <= 1.0f && f.z >= 0.0f
                      && f.z <= 1.0f)
              << c << " " << film << " " << f0 << " " << thickness;
        }
}

TEST(thin_film, float32_keeps_its_digits_at_grazing_angles_on_mirrors_and_in_thick_films) {
  constexpr double rounding = 2e-5; // phases of hundreds of radians, whose fringes no longer show
  double worst = 0.0;
  for (const float c : {1e-6f, 1e-4f, 1e-2f, 0.1f, 0.5f, 0.999f, 1.0f})
    for (const float film : {1.001f, 1.3f, 1.8f, 3.0f})
      for (const float f0 : {0.01f, 0.04f, 0.5f, 0.99f})
        for (const float thickness : {1.0f, 100.0f, 400.0f, 1000.0f, 5000.0f, 1e5f}) {
          const auto single = glsl::f32::filmFresnel(c, film, thickness,
                                                     glsl::f32::vec3(glsl::f32::filmBaseIor(f0)));
          const auto exact = f64::filmFresnel(
              c, film, thickness, glm::dvec3(f64::filmBaseIor(static_cast<double>(f0))));
          worst = std::max(worst, farthest(glm::dvec3(single), exact));
        }
  EXPECT_LT(worst, rounding);
}

TEST(thin_film, reflectance_at_normal_incidence_and_index_are_each_others) {
  for (const double f0 : {0.0, 0.02, 0.04, 0.5, 0.95})
    EXPECT_NEAR(f64::fresnelNormalIncidence(f64::filmBaseIor(f0)), f0, 1e-12);
}

} // namespace gg::test
