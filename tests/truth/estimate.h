// Means with their errors, and comparisons that know them.
#pragma once

#include "truth/integrator.h"

#include <gtest/gtest.h>

namespace gg::truth::test {

struct Estimate {
  glm::dvec3 mean{0.0}, error{0.0}; // standard error of the mean
};

// Of `samples` paths along one ray.
Estimate trace(const Integrator& integrator, const Ray& ray, long samples, std::uint64_t seed = 1);

// Within five standard errors (one chance in 1.7 million to be wrong on a channel), and within
// `slack` for what is not noise: rounding, or the facets of a mesh.
::testing::AssertionResult agrees(const Estimate& estimate, const glm::dvec3& expected,
                                  double slack);

// Rays start 2^-20 of the scene's size off the surfaces (Geometry::leave) and end at float32's
// rounding; the scenes are a few metres large.
constexpr double rounding = 4e-6;

// Of a scene without an eye among its solids.
Integrator integrator_of(const scene::Scene& scene, const EnvironmentLight* environment,
                         const Integrator::Settings& settings = {});

double degrees(double angle); // in radians
// A ray that meets the origin at this angle from +Z.
Ray towards_origin(double theta);

environment::Map black_map(int width, int height);
// The three values of a pixel, to be written.
float* texel(environment::Map& map, int x, int y);
EnvironmentLight constant_environment(const glm::vec3& radiance);

} // namespace gg::truth::test
