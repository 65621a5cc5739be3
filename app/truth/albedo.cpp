#include "truth/albedo.h"

#include "glsl/f64.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gg::truth {
namespace {

namespace f64 = glsl::f64;

// Of one surface at one angle. Visible normals leave G1(wi) as the weight, whose deviation is a
// quarter at most: 0.004 here, and less between nodes.
double albedo_of(scene::Distribution distribution, Smith smith, double alpha, double cosine) {
  constexpr std::uint64_t samples = 4096;
  const Interface mirror{.distribution = distribution,
                         .alpha = alpha,
                         .smith = smith,
                         .eta = 0.0,
                         .metallic = 1.0,
                         .metal_f0 = glm::dvec3(1.0)};
  const glm::dvec3 n(0.0, 0.0, 1.0), wo(std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine);
  const Closure closure(mirror, n, wo);
  double sum = 0.0;
  for (std::uint64_t k = 0; k < samples; ++k) {
    Random random(0, 0, k);
    for (const Drawn& drawn : closure.sample(random))
      sum += drawn.weight.x;
  }
  // Phong's D and G1 do not belong together, and it can return more than it gets.
  return std::min(sum / static_cast<double>(samples), 1.0);
}

// Where v in [0, 1] falls between n nodes.
struct Between {
  int low;
  double part;
};
Between between(double v, int n) {
  const double at = std::clamp(v, 0.0, 1.0) * (n - 1);
  const int low = std::min(static_cast<int>(at), n - 2);
  return {low, at - low};
}

} // namespace

Albedo::Albedo(scene::Distribution distribution, Smith smith)
    : values_(static_cast<std::size_t>(cosines * widths), 1.0), means_(widths, 1.0) {
  // The first row, alpha 0, is a mirror.
  tbb::parallel_for(1, widths, [&](int k) {
    for (int i = 0; i < cosines; ++i) {
      // On the horizon itself nothing is seen; a tenth of the first step stands for it.
      const double t = std::max(static_cast<double>(i), 0.1) / (cosines - 1);
      values_[static_cast<std::size_t>(k * cosines + i)] =
          albedo_of(distribution, smith, static_cast<double>(k) / (widths - 1), t * t);
    }
    // 2 int e c dc = 4 int e t³ dt, by the trapezium.
    double sum = 0.5 * node(cosines - 1, k);
    for (int i = 1; i < cosines - 1; ++i)
      sum += node(i, k) * std::pow(static_cast<double>(i) / (cosines - 1), 3.0);
    // The same sum for e = 1 is the rule's own error: 1 + (1 / steps)².
    constexpr double step = 1.0 / (cosines - 1);
    means_[static_cast<std::size_t>(k)] = 4.0 * sum * step / (1.0 + step * step);
  });
}

double Albedo::at(double cosine, double alpha) const {
  const auto [i, u] = between(std::sqrt(std::clamp(cosine, 0.0, 1.0)), cosines);
  const auto [k, v] = between(alpha, widths);
  return (node(i, k) * (1.0 - u) + node(i + 1, k) * u) * (1.0 - v)
         + (node(i, k + 1) * (1.0 - u) + node(i + 1, k + 1) * u) * v;
}

double Albedo::mean(double alpha) const {
  const auto [k, v] = between(alpha, widths);
  return means_[static_cast<std::size_t>(k)] * (1.0 - v)
         + means_[static_cast<std::size_t>(k) + 1] * v;
}

glm::dvec3 Albedo::tint(const Interface& metal) const {
  // The mean reflectance over the hemisphere, 2 int F c dc, by Gauss and Legendre's rule of four
  // nodes on [0, 1].
  constexpr double nodes[4] = {0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558};
  constexpr double weights[4] = {0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226};
  Interface alone = metal;
  alone.metallic = 1.0;
  alone.many_bounces = nullptr;
  const Closure closure(alone, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1.0));
  glm::dvec3 reflectance(0.0);
  for (int i = 0; i < 4; ++i)
    reflectance += 2.0 * weights[i] * nodes[i] * closure.fresnel(nodes[i]).reflected;
  return f64::multipleFresnelRgb(reflectance, mean(metal.alpha));
}

} // namespace gg::truth
