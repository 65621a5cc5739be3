// The white furnace: light of 1 from everywhere makes every surface show its own albedo.
#include "glsl/f64.h"
#include "render/harness.h"
#include "render/shapes.h"

#include <cmath>
#include <numbers>

namespace gg::test::furnace_test {
namespace {

namespace f64 = glsl::f64;

constexpr int size = 192;

frame::FrameDesc close_up() {
  return {.width = size, .height = size, .samples = 1, .camera = camera_at({0, 0, 3.2f})};
}

// The share of light that a metal with F = 1 reflects at cos(theta_o) = mu: the integral of D V cos
// over the hemisphere of wi, over facets instead: visible normals, for which f cos / pdf = G2 /
// G1(wo), which is smooth. 192 x 192 midpoints leave less than .1 % (against 512 x 512; the most
// at grazing).
double single_scatter_albedo(double mu, double alpha, bool correlated) {
  const glm::dvec3 n(0, 0, 1), wo(std::sqrt(1.0 - mu * mu), 0, mu);
  constexpr int steps = 192;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const glm::dvec3 wm =
          f64::ggxSampleVisible(wo, glm::dvec2(alpha), {(i + 0.5) / steps, (j + 0.5) / steps});
      const glm::dvec3 wi = 2.0 * glm::dot(wo, wm) * wm - wo;
      if (wi.z <= 0.0) continue;
      const auto i_tilt = f64::tilt(wi), o_tilt = f64::tilt(wo);
      sum += correlated ? f64::ggxG2Correlated(i_tilt, o_tilt, alpha) / f64::ggxG1(o_tilt, alpha)
                        : f64::ggxG1(i_tilt, alpha);
    }
  return sum / (steps * steps);
}

// The same by linear interpolation in theta from 65 values: within .13 % with the above.
struct Albedo {
  std::vector<double> values;
  Albedo(double alpha, bool correlated) {
    for (int k = 0; k <= 64; ++k)
      values.push_back(single_scatter_albedo(std::max(std::cos(k * std::numbers::pi / 128), 1e-9),
                                             alpha, correlated));
  }
  double at(double mu) const {
    const double x = std::acos(mu) * 128 / std::numbers::pi;
    const int k = std::min(static_cast<int>(x), 63);
    return values[k] + (x - k) * (values[k + 1] - values[k]);
  }
};

} // namespace

// Issue: "reproduces the single-scatter albedo within 0.5 % for alpha .05-1 at every pixel of a
// ball".
TEST_P(Render, metal_ball_in_the_white_furnace_shows_its_single_scatter_albedo) {
  constexpr double allowed = 0.005;
  for (const bool correlated : {false, true})
    for (const double alpha : {0.05, 0.1, 0.25, 0.5, 0.75, 1.0}) {
      const Albedo albedo(alpha, correlated);
      frame::FrameDesc desc = close_up();
      desc.correlated_smith = correlated;
      const scene::Camera& camera = desc.camera;
      const image::Image picture = draw(ball(metal(static_cast<float>(std::sqrt(alpha)))),
                                        {environment::constant(glm::vec3(1.0f)), desc});
      double worst = 0.0, worst_mu = 0.0;
      int checked = 0;
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          const glm::dvec3 d = view_direction(camera, size, size, x, y);
          const auto n = hit_ball(glm::dvec3(camera.world[3]), d);
          if (!n
              || !hit_ball(glm::dvec3(camera.world[3]),
                           view_direction(camera, size, size, x + 0.5, y))
              || !hit_ball(glm::dvec3(camera.world[3]),
                           view_direction(camera, size, size, x - 0.5, y)))
            continue;
          const double mu = -glm::dot(*n, d);
          const double error = std::abs(picture.at(x, y, 0) / albedo.at(mu) - 1.0);
          if (error > worst) worst = error, worst_mu = mu;
          ++checked;
        }
      EXPECT_LT(worst, allowed) << "alpha " << alpha << (correlated ? " correlated" : " separable")
                                << ", cos " << worst_mu;
      EXPECT_GT(checked, 10000);
    }
}

// With --multiscatter a surface that reflects everything sends everything back: [KullaConty17]'s lobe holds what single
// scattering loses. What is left is the quadrature of its mean albedo.
TEST_P(Render, metal_ball_with_multiple_scattering_vanishes_in_the_white_furnace) {
  constexpr float quadrature = 0.01f;
  for (const float roughness : {0.3f, 0.7f, 1.0f}) {
    frame::FrameDesc desc = close_up();
    desc.multiple_scattering = true;
    const image::Image picture =
        draw(ball(metal(roughness)), {environment::constant(glm::vec3(1.0f)), desc});
    float most = 0.0f, least = 2.0f;
    for (const float v : picture.values)
      most = std::max(most, v), least = std::min(least, v);
    EXPECT_LT(most, 1.0f + quadrature) << "roughness " << roughness;
    EXPECT_GT(least, 1.0f - quadrature) << "roughness " << roughness;
  }
}

// What glTF's dielectric sends back of light that comes from everywhere: specular with exact Fresnel over visible normals,
// and (1 - F(wo . wm)) / pi under it over the cosine. Appendix B adds them as they are: the base is only told what the facet
// between wi and wo reflects, so a white base seen at grazing shows up to 1.84 of what there is. That is the model.
double dielectric_albedo(double mu, double alpha, double eta) {
  const glm::dvec3 n(0, 0, 1), wo(std::sqrt(1.0 - mu * mu), 0, mu);
  constexpr int steps = 256; // midpoints per axis: 2e-4
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const glm::dvec2 u((i + 0.5) / steps, (j + 0.5) / steps);
      const glm::dvec3 wm = f64::ggxSampleVisible(wo, glm::dvec2(alpha), u);
      const glm::dvec3 reflected = 2.0 * glm::dot(wo, wm) * wm - wo;
      if (reflected.z > 0.0)
        sum += f64::fresnelDielectricAt(glm::dot(wo, wm), eta)
               * f64::ggxG1(f64::tilt(reflected), alpha);
      const double r = std::sqrt(u.x), phi = 2.0 * std::numbers::pi * u.y;
      const glm::dvec3 wi(r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0 - u.x));
      sum += 1.0 - f64::fresnelDielectricAt(0.5 * glm::length(wi + wo), eta);
    }
  return sum / (steps * steps);
}

TEST_P(Render, white_dielectric_ball_in_the_furnace_shows_what_gltf_asks_for) {
  // The tables' own: two effective angles stand for the facets (0.003), interpolated.
  constexpr double allowed = 0.006;
  for (const float roughness : {0.25f, 0.5f, 0.8f, 1.0f})
    for (const float ior : {1.3f, 1.5f, 2.0f}) {
      scene::Material white = dielectric(roughness, glm::vec3(1.0f));
      white.ior = ior;
      const frame::FrameDesc desc = close_up();
      const image::Image picture =
          draw(ball(white), {environment::constant(glm::vec3(1.0f)), desc});
      for (const int x : {96, 120, 144, 160, 168}) {
        const glm::dvec3 eye(desc.camera.world[3]),
            d = view_direction(desc.camera, size, size, x, 96);
        const auto n = hit_ball(eye, d);
        ASSERT_TRUE(n) << x;
        const double mu = -glm::dot(*n, d),
                     alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
        EXPECT_NEAR(picture.at(x, 96, 0), dielectric_albedo(mu, alpha, static_cast<double>(ior)),
                    allowed)
            << "roughness " << roughness << ", ior " << ior << ", cos " << mu;
      }
    }
}

} // namespace gg::test::furnace_test
