#include "truth/estimate.h"

#include <cmath>
#include <numbers>

namespace gg::truth::test {

Estimate trace(const Integrator& integrator, const Ray& ray, long samples, std::uint64_t seed) {
  glm::dvec3 sum(0.0), squares(0.0);
  for (long k = 0; k < samples; ++k) {
    Random random(seed, 0, static_cast<std::uint64_t>(k));
    const glm::dvec3 x = integrator.trace(ray, random).radiance;
    sum += x;
    squares += x * x;
  }
  const double n = static_cast<double>(samples);
  const glm::dvec3 mean = sum / n;
  return {mean, glm::sqrt(glm::max(squares / n - mean * mean, glm::dvec3(0.0)) / (n - 1.0))};
}

::testing::AssertionResult agrees(const Estimate& estimate, const glm::dvec3& expected,
                                  double slack) {
  constexpr double sigmas = 5.0;
  for (int c = 0; c < 3; ++c) {
    const double off = std::abs(estimate.mean[c] - expected[c]);
    if (!(off <= sigmas * estimate.error[c] + slack))
      return ::testing::AssertionFailure()
             << "channel " << c << " is " << estimate.mean[c] << " +- " << estimate.error[c]
             << ", expected " << expected[c];
  }
  return ::testing::AssertionSuccess();
}

Integrator integrator_of(const scene::Scene& scene, const EnvironmentLight* environment,
                         const Integrator::Settings& settings) {
  return Integrator(scene, environment, std::nullopt, settings);
}

double degrees(double angle) {
  return angle * std::numbers::pi / 180.0;
}

Ray towards_origin(double theta) {
  const glm::dvec3 from(std::sin(theta), 0.0, std::cos(theta));
  return {5.0 * from, -from};
}

environment::Map black_map(int width, int height) {
  environment::Map map{.name = "test", .width = width, .height = height};
  map.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return map;
}

float* texel(environment::Map& map, int x, int y) {
  return map.rgb.data()
         + 3
               * (static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width)
                  + static_cast<std::size_t>(x));
}

EnvironmentLight constant_environment(const glm::vec3& radiance) {
  return EnvironmentLight(environment::constant(radiance), 0.0, 1.0);
}

} // namespace gg::truth::test
