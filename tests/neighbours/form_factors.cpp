// Shares of the cosine lobe against counting rays.
#include "glsl/f64.h"
#include "neighbours/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace gg::neighbours_test {
namespace {

namespace f64 = gg::glsl::f64;

constexpr double quadrature = 0.004; // 25,600 rays: the error of counting along an outline
constexpr double clipped_cap =
    0.065; // a polygon across the horizon as the cap of the same vector [HillHeitz17]

f64::vec3 vec(const dvec3& v) {
  return {v.x, v.y, v.z};
}

} // namespace

TEST(form_factors, of_spheres_are_exact_above_and_across_the_horizon) {
  const dvec3 n(0, 1, 0);
  double worst = 0.0;
  for (const double rho : {0.05, 0.2, 0.5, 1.0, 1.4})
    for (double theta = 0.0; theta < 3.14; theta += 0.1) {
      const dvec3 axis(std::sin(theta), std::cos(theta), 0);
      const double truth =
          cosine_share_of(n, [&](const dvec3& ray) { return glm::dot(ray, axis) > std::cos(rho); });
      const double error =
          f64::sphereFormFactor(vec(2.0 * axis), 2.0 * std::sin(rho), vec(n)) - truth;
      worst = std::max(worst, std::abs(error));
      EXPECT_NEAR(error, 0.0, quadrature) << rho << ' ' << theta;
    }
  std::printf("sphere: worst error of the form factor %.4f\n", worst);
}

TEST(form_factors, of_rectangles_are_exact_above_the_horizon_and_near_across_it) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double squares = 0.0, worst = 0.0;
  int count = 0;
  for (int i = 0; i < 300; ++i) {
    const dvec3 u(std::exp(uniform(random)), 0, 0), v(0, 0, std::exp(uniform(random)));
    const dvec3 centre(uniform(random), -std::exp(uniform(random)), uniform(random));
    const dvec3 n = glm::normalize(dvec3(uniform(random), uniform(random), uniform(random)));
    const double truth =
        cosine_share_of(n, [&](const dvec3& ray) { return meets_rectangle(ray, centre, u, v); });
    const double error = f64::rectangleFormFactor(vec(centre), vec(u), vec(v), vec(n)) - truth;
    double lowest = 1.0;
    for (const double a : {-1.0, 1.0})
      for (const double b : {-1.0, 1.0})
        lowest = std::min(lowest, glm::dot(centre + a * u + b * v, n));
    EXPECT_NEAR(error, 0.0, lowest > 0.0 ? quadrature : clipped_cap) << i;
    squares += error * error;
    worst = std::max(worst, std::abs(error));
    ++count;
  }
  std::printf("rectangle: rms/worst error of the form factor %.4f/%.4f\n",
              std::sqrt(squares / count), worst);
}

TEST(form_factors, of_a_wall_that_surrounds_the_point_is_one) {
  EXPECT_NEAR(f64::rectangleFormFactor({0, -1e-3, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}), 1.0, 0.01);
  EXPECT_NEAR(f64::rectangleFormFactor({0, -1e-3, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}), 0.0, 0.01);
}

TEST(form_factors, are_finite_on_what_they_are_of) {
  for (const dvec3& n : {dvec3(0, 1, 0), dvec3(1, 0, 0), dvec3(0, -1, 0)}) {
    const double factors[] = {f64::sphereFormFactor({0, 0, 0}, 1.0, vec(n)),
                              f64::sphereFormFactor({0, 1, 0}, 1.0, vec(n)),
                              f64::rectangleFormFactor({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, vec(n)),
                              f64::rectangleFormFactor({1, 0, 1}, {1, 0, 0}, {0, 0, 1}, vec(n))};
    for (const double f : factors)
      EXPECT_TRUE(f >= 0.0 && f <= 1.0) << f;
  }
}

} // namespace gg::neighbours_test
