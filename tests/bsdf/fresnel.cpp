// Fresnel's equations: the values that every textbook gives, and identities between independent
// forms.
#include "bsdf/distributions.h"
#include "glsl/f32.h"

#include <gtest/gtest.h>

#include <complex>

namespace gg::bsdf_test {
namespace {

namespace f32 = gg::glsl::f32;
constexpr double rounding = 4e-15; // a dozen operations in double

// The textbook's way: complex amplitudes by Snell's law, nothing rearranged. For metals and for
// total reflection alike.
struct Textbook {
  double s, p;
  double mean() const { return 0.5 * (s + p); }
};
Textbook textbook(double c, std::complex<double> index) {
  const double sin2 = 1 - c * c;
  const std::complex<double> inner =
      std::sqrt(index * index - sin2); // index times the inner cosine
  const std::complex<double> rs = (c - inner) / (c + inner);
  const std::complex<double> rp = (index * index * c - inner) / (index * index * c + inner);
  return {std::norm(rs), std::norm(rp)};
}

TEST(fresnel, is_four_percent_at_normal_incidence_on_glass) {
  EXPECT_NEAR(f64::fresnelDielectricAt(1.0, 1.5), 0.04, rounding);
  EXPECT_NEAR(f64::fresnelDielectricAt(1.0, 1 / 1.5), 0.04, rounding);
  EXPECT_NEAR(f64::fresnelNormalIncidence(1.5), 0.04, rounding);
}

TEST(fresnel, of_p_light_vanishes_at_brewsters_angle) {
  for (double eta : {1.1, 1.5, 2.4, 4.0, 1 / 1.5}) {
    const double c = std::cos(std::atan(eta));
    EXPECT_LT(f64::fresnelPolarizedAt(c, eta).p, 1e-28) << eta;
    EXPECT_GT(f64::fresnelPolarizedAt(c, eta).s, 1e-3) << eta;
  }
}

TEST(fresnel, is_one_at_grazing_incidence) {
  for (double eta : {1.01, 1.5, 4.0}) {
    EXPECT_DOUBLE_EQ(f64::fresnelDielectricAt(0.0, eta), 1.0);
    EXPECT_NEAR(f64::fresnelDielectricAt(1e-9, eta), 1.0, 1e-6);
  }
}

TEST(fresnel, is_one_past_the_critical_angle) {
  for (double n : {1.05, 1.5, 2.4}) {
    const double critical = std::asin(1 / n);
    for (double past : {1e-6, 1e-3, 0.05, 1.0})
      if (critical + past < 90 * degree) {
        EXPECT_EQ(f64::fresnelDielectricAt(std::cos(critical + past), 1 / n), 1.0);
        EXPECT_EQ(f64::fresnelTransmittedAt(std::cos(critical + past), 1 / n), 0.0);
      }
    EXPECT_LT(f64::fresnelDielectricAt(std::cos(critical - 1e-3), 1 / n), 0.9);
  }
}

TEST(fresnel, is_zero_when_the_indices_match) {
  for (double c : {0.0, 1e-6, 0.3, 1.0}) {
    EXPECT_EQ(f64::fresnelDielectricAt(c, 1.0), 0.0);
    EXPECT_EQ(f64::fresnelTransmittedAt(c, 1.0), 1.0);
  }
}

TEST(fresnel, equals_the_textbook_for_both_polarisations) {
  for (double eta : {0.4, 0.66, 0.9, 1.1, 1.5, 2.4, 4.0})
    for (int k = 0; k <= 90; ++k) {
      const double c = std::cos(k * degree);
      const Textbook exact = textbook(c, eta);
      const f64::Polarized r = f64::fresnelPolarizedAt(c, eta);
      // The textbook's own subtraction costs it about 1e-14 near matched indices.
      EXPECT_NEAR(r.s, exact.s, 1e-13) << eta << " " << k;
      EXPECT_NEAR(r.p, exact.p, 1e-13) << eta << " " << k;
    }
}

TEST(fresnel, reflected_and_transmitted_sum_to_one) {
  for (double eta : {0.4, 0.66, 0.999999, 1.000001, 1.5, 4.0})
    for (double c : {0.0, 1e-7, 1e-3, 0.2, 0.7453559924999299, 0.9, 1.0})
      EXPECT_NEAR(f64::fresnelDielectricAt(c, eta) + f64::fresnelTransmittedAt(c, eta), 1.0,
                  rounding);
  for (double n : {0.05, 0.5, 1.0, 2.0})
    for (double k : {0.0, 0.5, 3.0, 10.0})
      for (double c : {0.0, 1e-7, 1e-3, 0.2, 0.9, 1.0})
        EXPECT_NEAR(f64::fresnelConductor(c, n, k) + f64::fresnelAbsorbed(c, n, k), 1.0, rounding)
            << n << " " << k << " " << c;
}

TEST(fresnel, is_the_same_from_both_sides_along_one_ray) {
  for (double eta : {1.1, 1.5, 2.4})
    for (double c : {0.05, 0.3, 0.8, 1.0}) {
      const double inner = f64::fresnelG(c, eta) / eta;
      EXPECT_NEAR(f64::fresnelDielectricAt(c, eta), f64::fresnelDielectricAt(inner, 1 / eta),
                  5 * rounding); // 1 / eta is rounded too
    }
}

TEST(fresnel, of_a_conductor_without_absorption_is_the_dielectrics) {
  for (double eta : {0.4, 0.66, 0.999, 1.001, 1.5, 4.0})
    for (int k = 0; k <= 90; ++k) {
      const double c = std::cos(k * degree);
      EXPECT_NEAR(f64::fresnelConductor(c, eta, 0.0), f64::fresnelDielectricAt(c, eta), 1e-13)
          << eta << " " << k;
    }
}

TEST(fresnel, of_metals_equals_the_textbook) {
  for (double n : {0.05, 0.2, 1.0, 2.9})
    for (double k : {0.1, 1.0, 3.9, 10.0})
      for (int angle = 0; angle <= 90; ++angle) {
        const double c = std::cos(angle * degree);
        EXPECT_NEAR(f64::fresnelConductor(c, n, k), textbook(c, {n, k}).mean(), 1e-14);
      }
}

TEST(fresnel, of_metals_is_computed_channel_by_channel) {
  const vec3 n(0.2, 0.9, 1.4), k(3.9, 2.4, 1.6);
  const vec3 rgb = f64::fresnelConductorRgb(0.6, n, k);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(rgb[i], f64::fresnelConductor(0.6, n[i], k[i]));
}

TEST(fresnel, keeps_its_digits_in_float_where_the_indices_nearly_match) {
  // F is 2.5e-13 at 1 + 1e-6; by 1 - cos terms it would be rounding noise.
  for (float d : {1e-6F, 1e-4F, 1e-2F})
    for (float c : {1.0F, 0.7F, 0.1F}) {
      const float eta = 1.0F + d;
      const double exact = f64::fresnelDielectricAt(double(c), double(eta));
      EXPECT_NEAR(double(f32::fresnelDielectricAt(c, eta)) / exact, 1.0, 2e-6) << d << " " << c;
    }
}

TEST(schlick, is_off_by_no_more_than_its_header_says) {
  const auto worst = [](double eta) {
    double most = 0;
    for (int k = 0; k <= 900; ++k) {
      const double c = std::cos(0.1 * k * degree);
      const double approximate = f64::fresnelSchlick(c, f64::fresnelNormalIncidence(eta));
      most = std::max(most, std::abs(approximate - f64::fresnelDielectricAt(c, eta)));
    }
    return most;
  };
  constexpr double printed = 5e-4; // half of the last digit in the header
  EXPECT_NEAR(worst(1.1), 0.210, printed);
  EXPECT_NEAR(worst(1.5), 0.036, printed);
  EXPECT_NEAR(worst(2.4), 0.074, printed);
}

TEST(schlick, agrees_with_its_colour_form) {
  const vec3 f0(0.04, 0.5, 0.95);
  for (int i = 0; i < 3; ++i)
    EXPECT_DOUBLE_EQ(f64::fresnelSchlickRgb(0.3, f0)[i], f64::fresnelSchlick(0.3, f0[i]));
}

TEST(diffuse, lies_under_the_specular_lobe) {
  const vec3 f = f64::diffuseF(vec3(0.5, 0.25, 1.0), 0.04);
  EXPECT_NEAR(f.x * 3.14159265358979, 0.48, 1e-14);
  EXPECT_EQ(f64::diffuseFCos(vec3(0.5), 0.2, 0.5).x, f64::diffuseF(vec3(0.5), 0.2).x * 0.5);
}

} // namespace
} // namespace gg::bsdf_test
