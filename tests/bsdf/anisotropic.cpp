// GGX with two widths: the isotropic one where they are equal, and a distribution where they are
// not.
#include "bsdf/quadrature.h"
#include "glsl/f32.h"

#include <gtest/gtest.h>

namespace gg::bsdf_test {
namespace {

const std::vector<vec2> widths{{0.1, 0.5}, {0.7, 0.2}, {0.3, 0.3}};
constexpr double rounding = 1e-13;
constexpr double quadrature = 1e-6; // 400 Gauss nodes about the wider slope, 400 azimuths

double about(vec2 alpha, const std::function<double(vec3)>& f) {
  return integrate_about_normal(std::sqrt(alpha.x * alpha.y), 400, 400, f);
}

TEST(anisotropic, with_equal_widths_is_ggx) {
  for (double a : {0.01, 0.4, 1.0})
    for (double theta : {0.01, 0.9, 1.5}) {
      const vec3 w = direction(theta, 0.7), v = direction(0.8, 3.0);
      const vec2 alpha(a);
      const Tilt t = f64::tilt(w), u = f64::tilt(v);
      EXPECT_NEAR(f64::ggxAnisoD(w * 2.5, alpha) / f64::ggxD(t, a), 1, rounding);
      EXPECT_NEAR(f64::ggxAnisoLambda(w, alpha) / f64::ggxLambda(t, a), 1, rounding);
      EXPECT_NEAR(f64::ggxAnisoG1(w, alpha) / f64::ggxG1(t, a), 1, rounding);
      EXPECT_NEAR(f64::ggxAnisoG2(w, v, alpha) / f64::ggxG2(t, u, a), 1, rounding);
      EXPECT_NEAR(f64::ggxAnisoV(w, v, alpha) / f64::ggxV(t, u, a), 1, rounding);
      EXPECT_NEAR(f64::ggxAnisoVCorrelated(w, v, alpha) / f64::ggxVCorrelated(t, u, a), 1,
                  rounding);
      EXPECT_NEAR(f64::ggxAnisoPdf(w, alpha) / f64::ggxPdf(t, a), 1, rounding);
      EXPECT_NEAR(f64::distance(f64::ggxAnisoSample(alpha, vec2(0.3, 0.6)),
                                f64::ggxSample(a, vec2(0.3, 0.6))),
                  0, rounding);
    }
}

TEST(anisotropic, projected_area_integrates_to_one) {
  for (vec2 alpha : widths)
    EXPECT_NEAR(about(alpha, [&](vec3 m) { return f64::ggxAnisoD(m, alpha) * m.z; }), 1,
                quadrature);
}

TEST(anisotropic, shadowing_shows_the_projected_area_of_the_plane) {
  constexpr double kinked = 1e-4; // the kink of |wo . m| under 400 azimuths
  for (vec2 alpha : widths)
    for (double theta : {0.5, 1.2})
      for (double phi : {0.0, 0.8, 1.57}) {
        const vec3 wo = direction(theta, phi);
        const double seen = about(alpha, [&](vec3 m) {
          return f64::ggxAnisoD(m, alpha) * std::max(f64::dot(wo, m), 0.0);
        });
        EXPECT_NEAR(f64::ggxAnisoG1(wo, alpha) * seen / wo.z, 1, kinked) << theta << " " << phi;
      }
}

TEST(anisotropic, of_no_width_is_zero) {
  EXPECT_EQ(f64::ggxAnisoD(up, vec2(0, 0.3)), 0);
  EXPECT_EQ(f64::ggxAnisoD(vec3(0), vec2(0.3)), 0);
  EXPECT_EQ(f64::ggxAnisoPdf(up, vec2(0)), 0);
}

} // namespace

// Widths of 1 to a thousand, seen and lit along, across and at the horizon.
TEST(anisotropic, float32_keeps_its_digits_where_widths_differ_most) {
  constexpr double rounding = 2e-6; // a dozen operations
  double worst = 0.0;
  for (const float narrow : {1e-3f, 1e-2f, 0.3f})
    for (const float wide : {0.3f, 1.0f})
      for (const glsl::f32::vec3& w :
           {glsl::f32::vec3(0, 0, 1), glsl::f32::vec3(1e-4f, 1e-3f, 1),
            glsl::f32::vec3(0.8f, 1e-3f, 0.6f), glsl::f32::vec3(1e-3f, 0.8f, 0.6f),
            glsl::f32::vec3(1, 1e-3f, 1e-3f), glsl::f32::vec3(1e-3f, 1, 1e-5f)}) {
        const vec3 exact(w.x, w.y, w.z);
        const vec2 alpha(wide, narrow);
        const glsl::f32::vec2 single(wide, narrow);
        const auto off = [&](float ours, double theirs) {
          if (theirs > 1e-30)
            worst = std::max(worst, std::abs(static_cast<double>(ours) / theirs - 1.0));
        };
        off(glsl::f32::ggxAnisoD(w, single), f64::ggxAnisoD(exact, alpha));
        off(glsl::f32::ggxAnisoG1(w, single), f64::ggxAnisoG1(exact, alpha));
        off(glsl::f32::ggxAnisoV(w, w, single), f64::ggxAnisoV(exact, exact, alpha));
      }
  EXPECT_LT(worst, rounding);
}

// The share of light from all around that a surface reflects towards wo: visible normals on a lattice.
double albedo(vec3 wo, vec2 alpha) {
  constexpr int facets = 2048; // 2e-3 of noise
  double sum = 0;
  for (int i = 0; i < facets; ++i) {
    const vec2 u((i + 0.5) / facets, std::fmod(0.5 + i * 0.6180339887498949, 1.0));
    const vec3 wi = f64::reflectAbout(wo, f64::ggxSampleVisible(wo, alpha, u));
    if (wi.z > 0) sum += f64::ggxAnisoG1(wi, alpha) / facets;
  }
  return sum;
}

// environment/stretched_lobe.glsl: energy is read at the width of an isotropic surface that reflects about as much.
TEST(anisotropic, the_width_for_energy_is_that_of_a_surface_that_reflects_as_much) {
  constexpr double fitted =
      0.1; // worst of the fit, where the widths differ most and the view is grazing
  for (const vec2 alpha : {vec2(0.1, 0.02), vec2(0.7, 0.02), vec2(0.4, 0.25), vec2(1.0, 0.25),
                           vec2(1.0, 0.7), vec2(0.6, 0.6)})
    for (const double theta : {0.0, 0.8, 1.3})
      for (const double phi : {0.0, 0.8, 1.57}) {
        const vec3 wo = direction(theta, phi);
        const double width = f64::stretchedEnergyAlpha(wo, alpha);
        EXPECT_NEAR(albedo(direction(theta, 0), vec2(width)), albedo(wo, alpha),
                    alpha.x == alpha.y ? 5e-3 : fitted)
            << alpha.x << " " << alpha.y << " " << theta << " " << phi;
      }
}

TEST(anisotropic, the_parts_of_a_lobe_of_equal_widths_are_that_lobe) {
  for (const double a : {0.02, 0.3, 1.0})
    for (const double theta : {0.0, 0.8, 1.3})
      for (int k = 0; k < 2; ++k) {
        const auto part = f64::stretchedPart(direction(theta, 0.7), vec2(a), k, 2, 0.0, 1.0);
        EXPECT_NEAR(part.alpha / a, 1, 1e-3);
        EXPECT_NEAR(part.n.z, 1, 1e-3);
      }
}

// The parts of a stretched lobe (environment/stretched_lobe.glsl): finite, above the surface, and together no more than there is.
TEST(anisotropic, parts_of_a_stretched_lobe_stay_sound_at_every_angle) {
  for (const float narrow : {1e-3f, 0.05f, 0.5f})
    for (const float wide : {0.0501f, 0.5001f, 1.0f})
      for (const float z : {0.0f, 1e-6f, 1e-3f, 0.1f, 0.7f, 1.0f})
        for (const float azimuth : {0.0f, 0.7f, 1.5707963f}) {
          if (wide < narrow) continue;
          const float r = std::sqrt(1.0f - z * z);
          const glsl::f32::vec3 wo(r * std::cos(azimuth), r * std::sin(azimuth), z);
          const glsl::f32::vec2 alpha(wide, narrow);
          for (int k = 0; k < 8; ++k) {
            const auto part = glsl::f32::stretchedPart(wo, alpha, k, 8, 0.0f, 1.0f);
            EXPECT_TRUE(std::isfinite(part.weight) && part.weight >= 0.0f && part.n.z > 0.0f
                        && part.alpha > 0.0f && part.alpha <= 1.0f)
                << wide << " " << narrow << " " << z << " " << azimuth << " " << k;
          }
          const float width = glsl::f32::stretchedEnergyAlpha(wo, alpha);
          EXPECT_TRUE(width >= narrow && width <= wide) << wide << " " << narrow << " " << z;
        }
}

} // namespace gg::bsdf_test
