// In light that comes from everywhere alike, what a surface shows is what it does not lose.
#include "glsl/f64.h"
#include "truth/estimate.h"
#include "truth/scenes.h"

#include <numbers>

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;
namespace f64 = gg::glsl::f64;

TEST(truth_furnace, smooth_glass_ball_is_invisible_whatever_its_facets) {
  // Coarse on purpose: with 12 rings shading and triangle normals disagree by up to 8 degrees. No
  // light may be lost or leak where they do. (Nearer the rim a coarse ball's made-up normals can
  // catch light for good, on orbits that no round ball has.)
  // Nor by a film or a coat, which send on what they do not reflect.
  for (const int rings : {12, 32}) {
    scene::Scene scene;
    scene::Material layered = glass(0.0f);
    if (rings == 32) layered.iridescence = layered.clearcoat = 1.0f;
    add_ball(scene, layered, glm::vec3(0.0f), 1.0f, rings);
    const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
    const Integrator integrator = integrator_of(scene, &white);
    for (const double x : {0.0, 0.4, 0.8, 0.9, 0.95})
      EXPECT_TRUE(agrees(trace(integrator, {{x, 0.05, 5.0}, {0.0, 0.0, -1.0}}, 2000),
                         glm::dvec3(1.0), rounding))
          << rings << " rings, x " << x;
  }
}

// The albedo of a rough surface that reflects everything, by quadrature over wi.
double albedo(double alpha, double cos_o, bool correlated) {
  const glm::dvec3 n(0.0, 0.0, 1.0), wo(std::sqrt(1.0 - cos_o * cos_o), 0.0, cos_o);
  // The facet rather than wi is stepped through: its lobe is as wide as the grid for every alpha.
  // tan = alpha t / sqrt(1 - t²) spreads GGX evenly over t².
  constexpr int rings = 600, spokes = 240;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < spokes; ++j) {
      const double u = (i + 0.5) / rings, phi = 2.0 * std::numbers::pi * (j + 0.5) / spokes;
      const double tan = alpha * std::sqrt(u / (1.0 - u));
      const glm::dvec3 wm =
          glm::normalize(glm::dvec3(tan * std::cos(phi), tan * std::sin(phi), 1.0));
      if (glm::dot(wo, wm) <= 0.0) continue;
      const glm::dvec3 wi = f64::reflectAbout(wo, wm);
      const f64::Facet f = f64::reflectionFacet(wi, wo, n, 1.5);
      if (wi.z <= 0.0 || !f.exists) continue;
      const double d = f64::ggxD(f.h, alpha);
      const double v =
          correlated ? f64::ggxVCorrelated(f.wi, f.wo, alpha) : f64::ggxV(f.wi, f.wo, alpha);
      sum += d * v * wi.z / f64::reflectionPdf(f, d * wm.z);
    }
  return sum / (rings * spokes);
}

TEST(truth_furnace, metal_that_reflects_everything_shows_its_single_scatter_albedo) {
  constexpr double quadrature = 2e-4; // of `albedo`: halving its steps moves it by less
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  for (const Smith smith : {Smith::separable, Smith::correlated})
    for (const float alpha : {0.05f, 0.3f, 1.0f}) {
      scene::Scene scene;
      add_sheet(scene, metal(alpha), 100.0f, 0.0f);
      const Integrator integrator = integrator_of(scene, &white, {.smith = smith});
      for (const double theta : {0.0, 60.0, 80.0}) {
        const double expected = albedo(static_cast<double>(alpha), std::cos(degrees(theta)),
                                       smith == Smith::correlated);
        EXPECT_TRUE(agrees(trace(integrator, towards_origin(degrees(theta)), 20000),
                           glm::dvec3(expected), quadrature))
            << "alpha " << alpha << ", " << theta << " degrees, correlated "
            << (smith == Smith::correlated);
      }
    }
}

TEST(truth_furnace, rough_glass_loses_only_what_single_scattering_loses) {
  // What separable GGX of alpha .5 and index 1.5 loses at 0, 60 and 80 degrees, entering and
  // leaving, as a study found it by quadrature of [Walter07] and wrote it down to whole percents.
  constexpr double digits = 0.006;
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  scene::Scene scene;
  add_box(scene, glass(0.5f), {0.0f, 0.0f, -100.0f}, glm::vec3(100.0f)); // its top: z = 0
  const Integrator integrator =
      integrator_of(scene, &white, {.transport = Transport::surface_only});
  const double angles[] = {0.0, 60.0, 80.0};
  const double entering[] = {0.03, 0.12, 0.25}, leaving[] = {0.25, 0.36, 0.40};
  for (int i = 0; i < 3; ++i) {
    const Ray ray = towards_origin(degrees(angles[i]));
    const Ray from_behind{ray.origin * glm::dvec3(1.0, 1.0, -1.0),
                          ray.direction * glm::dvec3(1.0, 1.0, -1.0)};
    EXPECT_TRUE(agrees(trace(integrator, ray, 20000), glm::dvec3(1.0 - entering[i]), digits))
        << "entering at " << angles[i] << " degrees";
    EXPECT_TRUE(agrees(trace(integrator, from_behind, 20000), glm::dvec3(1.0 - leaving[i]), digits))
        << "leaving at " << angles[i] << " degrees";
  }
}

// With multiple scattering nothing is lost [KullaConty17].
TEST(truth_furnace, metal_that_reflects_everything_sends_everything_back_after_many_bounces) {
  constexpr double tabulated = 0.005; // Albedo
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  for (const auto distribution : {scene::Distribution::ggx, scene::Distribution::beckmann})
    for (const Smith smith : {Smith::separable, Smith::correlated}) {
      scene::Scene scene; // sheets beside each other
      for (const float alpha : {0.1f, 0.5f, 1.0f}) {
        scene::Material m = metal(alpha);
        m.distribution = distribution;
        add_sheet(scene, m, 1.0f, 0.0f);
        scene.instances.back().world[3].x = 10.0f * static_cast<float>(scene.instances.size() - 1);
      }
      const Integrator integrator =
          integrator_of(scene, &white, {.smith = smith, .multiple_scattering = true});
      for (std::size_t i = 0; i < scene.instances.size(); ++i)
        for (const double theta : {0.0, 60.0, 80.0}) {
          Ray ray = towards_origin(degrees(theta));
          ray.origin.x += 10.0 * static_cast<double>(i);
          EXPECT_TRUE(agrees(trace(integrator, ray, 10000), glm::dvec3(1.0), tabulated))
              << "sheet " << i << ", " << theta << " degrees";
        }
    }
}

} // namespace
