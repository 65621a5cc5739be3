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

environment::Map black_map(int width, int height);
// The three values of a pixel, to be written.
float* texel(environment::Map& map, int x, int y);
EnvironmentLight constant_environment(const glm::vec3& radiance);

} // namespace gg::truth::test
