// Shares of a Gaussian lobe in closed form against the series and against quadrature: the table of lobe_share.glsl.
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

constexpr double sigmas[] = {0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.65};
constexpr double radii[] = {0.02, 0.05, 0.1, 0.2, 0.35, 0.6, 0.9, 1.2, 1.5};
// What the closed forms were found to be off by (quadrature), with room for a last digit.
constexpr double sphere_rms = 0.004, sphere_worst = 0.02;           // sigma <= .35
constexpr double wide_sphere_rms = 0.016, wide_sphere_worst = 0.04; // up to .65
constexpr double rectangle_rms = 0.056, rectangle_worst = 0.2;

struct Error {
  double squares = 0.0, worst = 0.0;
  int count = 0;
  void add(double error) {
    squares += error * error;
    worst = std::max(worst, std::abs(error));
    ++count;
  }
  double rms() const { return std::sqrt(squares / std::max(count, 1)); }
};

f64::vec3 vec(const dvec3& v) {
  return {v.x, v.y, v.z};
}

// A sphere one metre away whose angular radius is rho.
f64::LobeShare sphere(double rho, double theta, double sigma) {
  return f64::sphereShare({0.0, 0.0, 1.0}, std::sin(rho), {std::sin(theta), 0.0, std::cos(theta)},
                          sigma);
}

} // namespace

TEST(shares, of_spheres_are_those_of_the_series) {
  std::printf(
      "sphere: rms/worst error of the share over angles up to the radius and 4 sigma\nsigma");
  for (const double rho : radii)
    std::printf("  rho %-6.2f", rho);
  for (const double sigma : sigmas) {
    std::printf("\n%5.2f", sigma);
    Error all;
    for (const double rho : radii) {
      Error error;
      for (int i = 0; i <= 40; ++i) {
        const double theta = std::min(3.14159, rho + 4.0 * sigma) * i / 40.0;
        const double e = sphere(rho, theta, sigma).share - cap_share(sigma, rho, theta);
        error.add(e);
        all.add(e);
      }
      std::printf("  .%03.0f/.%03.0f ", 1e3 * error.rms(), 1e3 * error.worst);
    }
    EXPECT_LT(all.rms(), sigma <= 0.35 ? sphere_rms : wide_sphere_rms) << sigma;
    EXPECT_LT(all.worst, sigma <= 0.35 ? sphere_worst : wide_sphere_worst) << sigma;
  }
  std::printf("\n");
}

TEST(shares, of_rectangles_are_those_of_quadrature) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto some = [&] { return dvec3(uniform(random), uniform(random), uniform(random)); };
  std::printf(
      "rectangle: sigma, rms/worst error of the share over sizes, heights, places and angles\n");
  for (const double sigma : sigmas) {
    const HeatKernel kernel(sigma);
    Error error;
    for (int i = 0; i < 150; ++i) {
      const double a = 3.14 * uniform(random), lu = std::exp(1.2 * uniform(random)),
                   lv = std::exp(1.2 * uniform(random));
      const dvec3 u(lu * std::cos(a), 0.0, lu * std::sin(a)),
          v(-lv * std::sin(a), 0.0, lv * std::cos(a));
      const dvec3 centre(2.5 * uniform(random), -std::exp(2.0 * uniform(random) - 1.0),
                         2.5 * uniform(random));
      const dvec3 at = centre + u * uniform(random) + v * uniform(random);
      const dvec3 direction = glm::normalize(glm::normalize(at) + 1.5 * sigma * some());
      const double truth = share_of(kernel, sigma, direction, [&](const dvec3& ray) {
        return meets_rectangle(ray, centre, u, v);
      });
      error.add(f64::rectangleShare(vec(centre), vec(u), vec(v), vec(direction), sigma).share
                - truth);
    }
    std::printf("%5.2f  .%03.0f/.%03.0f\n", sigma, 1e3 * error.rms(), 1e3 * error.worst);
    EXPECT_LT(error.rms(), rectangle_rms) << sigma;
    EXPECT_LT(error.worst, rectangle_worst) << sigma;
  }
}

TEST(shares, of_a_wall_without_end_are_those_of_its_half_space) {
  for (const double sigma : {0.05, 0.3})
    for (const double angle : {-0.3, 0.0, 0.2, 1.0}) {
      const auto met = f64::rectangleShare({0, -1, 0}, {1e4, 0, 0}, {0, 0, 1e4},
                                           {std::cos(angle), -std::sin(angle), 0}, sigma);
      EXPECT_NEAR(met.share, 0.5 * std::erfc(-angle / sigma / std::sqrt(2.0)), 0.02)
          << sigma << ' ' << angle;
    }
}

// What is met lies on the proxy, and the direction leads to it.
TEST(shares, directions_meet_the_sphere) {
  for (const double rho : radii)
    for (const double sigma : sigmas)
      for (const double theta : {0.0, 0.5 * rho, rho, rho + sigma}) {
        const auto met = sphere(rho, theta, sigma);
        const dvec3 at = met.distance * dvec3(met.direction) - dvec3(0, 0, 1);
        EXPECT_NEAR(glm::length(at), std::sin(rho), 0.05 * std::sin(rho)) << rho << ' ' << sigma;
        EXPECT_LE(glm::dot(dvec3(met.direction), dvec3(met.n)), 0.0);
        EXPECT_NEAR(glm::length(dvec3(met.direction)), 1.0, 1e-9);
      }
}

TEST(shares, change_smoothly_with_the_direction) {
  // A hundredth of sigma further, no share changes by more than the steepest Gaussian edge does.
  constexpr double steepest = 0.4 * 1.2;
  for (const double sigma : sigmas)
    for (const double rho : radii) {
      double before = sphere(rho, 0.0, sigma).share;
      for (double theta = 0.01 * sigma; theta < std::min(3.0, rho + 4.5 * sigma);
           theta += 0.01 * sigma) {
        const double share = sphere(rho, theta, sigma).share;
        EXPECT_LT(std::abs(share - before), 0.01 * steepest + 2e-4)
            << sigma << ' ' << rho << ' ' << theta;
        before = share;
      }
    }
}

TEST(shares, of_nothing_are_none) {
  const dvec3 up(0, 1, 0);
  EXPECT_EQ(f64::sphereShare({0, 0, 0}, 1.0, vec(up), 0.1).share, 0.0);
  EXPECT_EQ(f64::sphereShare({0, 0.5, 0}, 1.0, vec(up), 0.1).share, 0.0);
  // A radius of 0 leaves the rounding of a ratio of two vanishing numbers.
  EXPECT_NEAR(f64::sphereShare({0, 1, 0}, 0.0, vec(up), 0.1).share, 0.0, 1e-9);
  EXPECT_EQ(f64::rectangleShare({1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0.1).share, 0.0);
}

} // namespace gg::neighbours_test
