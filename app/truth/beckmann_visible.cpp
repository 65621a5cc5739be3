#include "truth/beckmann_visible.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::truth {
namespace {

namespace f64 = glsl::f64;

// The slope x, towards the viewer, of the facets that a viewer at elevation (cos, sin) sees on a
// surface of width 1. Its density is (cos - x sin) exp(-x²) / sqrt(pi) on x < cot [Heitz and d'Eon
// 2014, eq. 5, before the change of variables], which integrates in closed form:
//   P(x) = cos erfc(-x) / 2 + sin exp(-x²) / (2 sqrt pi).
// P(x) = u P(cot) is solved by Newton's steps, kept between bounds by halving.
double visible_slope(double cos_theta, double sin_theta, double u) {
  // Beyond 27 exp(-x²) is below the smallest double.
  double low = -27.0, high = 27.0;
  if (sin_theta > 0.0) high = std::min(high, cos_theta / sin_theta);
  const double tail = 0.5 * sin_theta / std::sqrt(std::numbers::pi);
  const auto cumulated = [&](double x) {
    return 0.5 * cos_theta * std::erfc(-x) + tail * std::exp(-x * x);
  };
  const double target = u * cumulated(high);
  double x = std::clamp(0.0, low, high);
  // Newton doubles the digits; where the density vanishes (at `high`) halving takes over, one bit
  // a step. 60 steps reach the last bit either way.
  for (int step = 0; step < 60; ++step) {
    const double excess = cumulated(x) - target;
    (excess > 0.0 ? high : low) = x;
    const double slope =
        (cos_theta - x * sin_theta) * std::exp(-x * x) / std::sqrt(std::numbers::pi);
    double next = slope > 0.0 ? x - excess / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double moved = std::abs(next - x);
    x = next;
    // Rounding: what a double near 1 resolves.
    if (moved < 0x1p-50) break;
  }
  return x;
}

} // namespace

glm::dvec3 beckmann_sample_visible(const glm::dvec3& wo, double alpha, Random& random) {
  // Stretched by alpha the surface has width 1 and its slopes are those above.
  const glm::dvec3 seen = glm::normalize(glm::dvec3(alpha * wo.x, alpha * wo.y, std::abs(wo.z)));
  const double across = std::hypot(seen.x, seen.y);
  const double along_view = visible_slope(seen.z, across, random.uniform());
  // The other slope is a Gaussian of variance 1/2 (Box and Muller).
  const double radius = std::sqrt(-std::log(1.0 - random.uniform()));
  const double aside = radius * std::cos(2.0 * std::numbers::pi * random.uniform());
  const glm::dvec2 axis = across > 0.0 ? glm::dvec2(seen) / across : glm::dvec2(1.0, 0.0);
  const glm::dvec2 slope = along_view * axis + aside * glm::dvec2(-axis.y, axis.x);
  return glm::normalize(glm::dvec3(-alpha * slope.x, -alpha * slope.y, 1.0));
}

double beckmann_pdf_visible(const f64::Facet& f, double alpha) {
  if (!f.exists) return 0.0;
  // G1 / |wo . n| without dividing by the cosine: G1 = a / A(a) with a = |wo . n| / r.
  const double r = alpha * std::sqrt(f.wo.p);
  const double g1_over_cos =
      f.wo.z >= 7.0 * r ? 1.0 / f.wo.z : 1.0 / (r * f64::beckmannAPlus(f.wo.z / r));
  return f64::beckmannD(f.h, alpha) * f.woDotM * g1_over_cos;
}

} // namespace gg::truth
