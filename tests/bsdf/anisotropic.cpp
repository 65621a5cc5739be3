// GGX with two widths: the isotropic one where they are equal, and a distribution where they are
// not.
#include "bsdf/quadrature.h"

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
} // namespace gg::bsdf_test
