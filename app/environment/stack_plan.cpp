#include "environment/stack_plan.h"

#include "glsl/f64.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace gg::environment {
namespace {

// A face of the sharp level spans a quarter of the picture's width, and has twice the texels of that, so that its Gaussian of half
// a pixel is 0.8 of a texel at the face's centre: enough to be without alias.
constexpr int least_face = 64, greatest_face = 1024;
constexpr int irradiance_source = 32;
constexpr double texels_per_sigma =
    1.25; // of even levels at a face's centre, where a texel is 2 / size wide
constexpr double sharp_pixels = 0.6; // sigma of the sharp level in pixels of the picture

// `kernel` of a step that ends at so many sigma.
vec4 kernel_of(double reach, double variance) {
  const double radius = reach * std::sqrt(variance), half = std::sin(0.5 * radius);
  return {radius, 4.0 * half * half, 0.5 / variance, 0.0};
}

Blur blur_of(const Place& to, bool halved, double variance) {
  Blur blur{.to = to};
  blur.step.kernel =
      kernel_of(glsl::f64::HEAT_KERNEL_REACH, variance / glsl::f64::HEAT_KERNEL_KEPT);
  // The four points that a halved texel is the mean of lie half a source texel off: a 16th of its area per axis, at a face's
  // centre of 4 / size², and half of it for each end.
  if (halved)
    blur.step.kernel.w = static_cast<float>(0.5 / 16.0 * 4.0 / (to.size * to.size) / variance);
  return blur;
}

} // namespace

Map fitted(const Map& map) {
  return fitted_between(map, least_face / 2, 2 * greatest_face);
}

int face_of(const Map& map) {
  return std::clamp(static_cast<int>(std::bit_ceil(static_cast<unsigned>(map.width / 2))),
                    least_face, greatest_face);
}

double sharp_sigma(const Map& map) {
  return sharp_pixels * std::numbers::pi / map.height;
}

int even_level_count(int face) {
  return std::countr_zero(static_cast<unsigned>(face / smallest_level)) + 1;
}

double even_sigma(int size) {
  return 2.0 * texels_per_sigma / size;
}

double odd_sigma(int size) {
  return std::numbers::sqrt2 * even_sigma(size);
}

double lookup_variance(int size) {
  return 4.0 * std::numbers::pi / (6.0 * size * size) / 6.0; // a sixth of a texel's area
}

StackPlan plan_stack(const Map& map) {
  StackPlan plan;
  const int face = face_of(map);
  double variance = sharp_sigma(map) * sharp_sigma(map);
  plan.sharp.sizes = {face, 0, map.width, map.height};
  plan.sharp.kernel = kernel_of(equirect_reach, variance);
  for (int level = 1; level < even_level_count(face); ++level) {
    const int size = face >> level;
    const Place even{false, level, size}, odd{true, level - 1, size};
    const double to_even = even_sigma(size) * even_sigma(size), to_odd = 2.0 * to_even;
    if (size > zonal_face) {
      plan.blurs.push_back(blur_of(even, true, to_even - variance));
      plan.blurs.push_back(blur_of(odd, false, to_odd - to_even));
      variance = to_odd;
    } else {
      plan.wide.push_back({even, to_even - variance});
      plan.wide.push_back({odd, to_odd - variance});
    }
    if (size == irradiance_source) plan.irradiance_source = odd;
  }
  plan.sharp.sizes.y = plan.blurs.front().to.size;
  for (std::size_t i = 0; i < plan.blurs.size(); ++i)
    plan.blurs[i].step.sizes = {plan.blurs[i].to.size,
                                i + 1 < plan.blurs.size() ? plan.blurs[i + 1].to.size : 0, 0, 0};
  return plan;
}

} // namespace gg::environment
