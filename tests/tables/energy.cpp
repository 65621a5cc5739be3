// The energies that shaders look up against the exact integral.
#include "tables/energy.h"

#include "tables/lookup.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

namespace gg::tables {
namespace {

// Between nodes and off them, from the horizon to the normal.
const double cosines[] = {0.0,  0.003, 0.011, 0.027, 0.05, 0.083, 0.13, 0.21,
                          0.34, 0.47,  0.63,  0.79,  0.92, 0.985, 1.0};
const double alphas[] = {0.05, 0.061, 0.087, 0.13, 0.21, 0.33, 0.47, 0.64, 0.81, 0.96, 1.0};
constexpr int points = 192; // squared; doubling them changes albedos by less than 3e-5

TEST(energy_table, albedo_of_a_lossless_metal_is_within_half_a_per_cent) {
  for (const Model& model : models) {
    double worst = 0.0;
    for (double alpha : alphas)
      for (double c : cosines) {
        const double exact =
            FacetAngles(reflection_lobe(model, alpha, c, Walk::grid, points)).albedo();
        const double error = reflection_energy_at(model, c, alpha).albedo / exact - 1.0;
        worst = std::max(worst, std::abs(error));
        EXPECT_NEAR(error, 0.0, 0.005) << name(model) << " alpha " << alpha << " cos " << c;
      }
    std::printf("    %-20s largest relative error %.5f\n", name(model).c_str(), worst);
  }
}

TEST(energy_table, two_angles_stand_for_every_fresnel_reflectance) {
  // A channel of radiance: four thousandths of the light that falls in.
  constexpr double tolerance = 0.004;
  for (const Model& model : models) {
    double worst = 0.0, squares = 0.0;
    int count = 0;
    std::string which;
    for (double alpha : alphas)
      for (double c : cosines) {
        const FacetAngles exact(reflection_lobe(model, alpha, c, Walk::grid, points / 2));
        const auto e = reflection_energy_at(model, c, alpha);
        for (const Reflectance& f : reflectances()) {
          const double error =
              e.albedo * glsl::f64::lobeMean(e, f.at(e.cos1), f.at(e.cos2)) - exact.integral(f.at);
          squares += error * error;
          ++count;
          if (std::abs(error) > worst) which = f.name;
          worst = std::max(worst, std::abs(error));
          EXPECT_NEAR(error, 0.0, tolerance)
              << name(model) << ' ' << f.name << " alpha " << alpha << " cos " << c;
        }
      }
    std::printf("    %-20s largest error %.5f (%s), rms %.5f\n", name(model).c_str(), worst,
                which.c_str(), std::sqrt(squares / count));
  }
}

// At alpha below .002 all that masking does happens within a fifth of a degree of the horizon, between two nodes.
TEST(energy_table, albedo_of_narrow_lobes_is_off_only_along_the_surface) {
  constexpr double along_surface = 0.07, elsewhere = 0.012;
  for (const Model& model : models) {
    double worst[2] = {};
    for (double alpha : {1e-5, 7e-5, 2e-4, 5e-4, 1e-3, 2e-3, 7e-3, 0.02, 0.045})
      for (double c : {0.0, 2e-4, 5e-4, 1e-3, 3e-3, 6e-3, 0.011, 0.027, 0.05, 0.13, 0.34, 0.79}) {
        const double exact =
            FacetAngles(reflection_lobe(model, alpha, c, Walk::grid, points / 2)).albedo();
        double& most = worst[alpha < 0.002 && c < 0.004 ? 0 : 1];
        most = std::max(most, std::abs(reflection_energy_at(model, c, alpha).albedo / exact - 1.0));
      }
    std::printf("    %-20s largest relative error %.4f along the surface, %.4f elsewhere\n",
                name(model).c_str(), worst[0], worst[1]);
    EXPECT_LT(worst[0], along_surface) << name(model);
    EXPECT_LT(worst[1], elsewhere) << name(model);
  }
}

TEST(energy_table, albedo_of_a_mirror_is_one) {
  for (double c : cosines)
    EXPECT_NEAR(reflection_energy_at(models[0], c, 0.0).albedo, 1.0, 1e-6) << c;
}

TEST(energy_table, diffuse_angles_stand_for_every_fresnel_reflectance) {
  double worst = 0.0;
  for (double c : cosines) {
    const auto angles = glsl::f64::diffuseAngles(c);
    for (const Reflectance& f : reflectances()) {
      if (f.name.starts_with("metal")) continue; // nothing diffuse under them
      // Mean over wi with weight cos / π: uniform in the squared radius of its projection.
      constexpr int rings = 200, spokes = 200;
      double sum = 0.0;
      for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j) {
          const double r2 = (i + 0.5) / rings, phi = std::numbers::pi * (j + 0.5) / spokes;
          const double cos_between =
              std::sqrt(r2) * std::cos(phi) * std::sqrt(1.0 - c * c) + std::sqrt(1.0 - r2) * c;
          sum += f.at(std::sqrt(0.5 * (1.0 + cos_between)));
        }
      const double got = angles.z * f.at(angles.x) + (1.0 - angles.z) * f.at(angles.y);
      worst = std::max(worst, std::abs(got - sum / (rings * spokes)));
    }
  }
  std::printf("    largest error %.5f\n", worst);
  EXPECT_LT(worst, 0.0005); // 0.0002 of the fit, and the quadrature's corner at the horizon
}

} // namespace
} // namespace gg::tables
