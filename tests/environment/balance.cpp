// With the weights of face_balance.h a convolution gives all the light of every texel to the results, no more and no less.
#include "environment/face_balance.h"
#include "environment/stack_plan.h"
#include "environment/zonal.h"
#include "glsl/f64.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>

namespace gg::environment {
namespace {

// Largest relative difference between a texel's solid angle and what it gives to the results, all pairs summed.
double worst_given(int size, int source_size, const std::vector<float>& weights,
                   const std::function<double(double chord)>& kernel) {
  const auto texels = [](int edge, const auto& use) {
    for (int face = 0; face < 6; ++face)
      for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
          use(glsl::f64::cubeTexelDirection(face, x, y, edge),
              glsl::f64::cubeTexelSolidAngle(x, y, edge), static_cast<std::size_t>(y * edge + x));
  };
  std::vector<double> given(weights.size(), 0.0);
  texels(size, [&](const glm::dvec3& to, double area, std::size_t) {
    double total = 0.0;
    std::vector<double> row(weights.size(), 0.0); // summed over the six faces, which give the same
    texels(source_size, [&](const glm::dvec3& from, double, std::size_t at) {
      const double part = kernel(glm::distance(to, from)) * static_cast<double>(weights[at]);
      row[at] += part;
      total += part;
    });
    for (std::size_t i = 0; i < row.size(); ++i)
      given[i] += area * row[i] / total;
  });
  double worst = 0.0;
  texels(source_size, [&](const glm::dvec3&, double area, std::size_t at) {
    worst = std::max(worst, std::abs(given[at] / (6.0 * area) - 1.0));
  });
  return worst;
}

std::vector<float> areas(int size) {
  std::vector<float> areas;
  for (int i = 0; i < size * size; ++i)
    areas.push_back(static_cast<float>(glsl::f64::cubeTexelSolidAngle(i % size, i / size, size)));
  return areas;
}

TEST(face_balance, blurs_lose_no_light_of_any_texel) {
  const Blur* blur = nullptr;
  const StackPlan plan = plan_stack(constant(glm::vec3(1.0f)));
  for (const Blur& b : plan.blurs)
    if (b.to.odd && b.to.size == 16) blur = &b; // not halved: its kernel is the same everywhere
  ASSERT_NE(blur, nullptr);
  const auto kernel = [&](double chord) {
    const double chord2 = chord * chord;
    return chord2 > static_cast<double>(blur->step.kernel.y)
               ? 0.0
               : glsl::f64::heatKernel(chord2, static_cast<double>(blur->step.kernel.z));
  };
  constexpr double left = 1e-4; // by six steps of the balance
  EXPECT_LT(worst_given(16, 16, blur_weights(16, blur->step.kernel), kernel), left);
  EXPECT_GT(worst_given(16, 16, areas(16), kernel), 10.0 * left);
}

TEST(face_balance, wide_kernels_lose_no_light_of_any_texel) {
  const auto table = heat_kernel_table(0.05, 4096);
  const auto kernel = [&](double chord) {
    return static_cast<double>(table[static_cast<std::size_t>(0.5 * chord * 4095.0 + 0.5)]);
  };
  constexpr double left = 1e-4; // by eight rounds of the balance
  EXPECT_LT(worst_given(8, 16, zonal_weights(8, 16, table), kernel), left);
  EXPECT_GT(worst_given(8, 16, areas(16), kernel), 10.0 * left);
}

} // namespace
} // namespace gg::environment
