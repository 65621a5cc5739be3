#include "bsdf/quadrature.h"

namespace gg::bsdf_test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int energy_grid = 256;

} // namespace

Rule gauss_legendre(int n, double a, double b) {
  Rule rule;
  for (int i = 0; i < n; ++i) {
    // Newton from the classical estimate of the i-th root; P_n and its derivative by the three-term
    // recurrence.
    double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 0;
    for (int step = 0; step < 8; ++step) {
      double previous = 1, value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
      }
      slope = n * (x * value - previous) / (x * x - 1);
      x -= value / slope;
    }
    rule.x.push_back(0.5 * (a + b) - 0.5 * (b - a) * x);
    rule.w.push_back((b - a) / ((1 - x * x) * slope * slope));
  }
  return rule;
}

double integrate_about_normal(double alpha, int nodes, int azimuths,
                              const std::function<double(vec3)>& f) {
  const Rule rule = gauss_legendre(nodes, 0.0, 0.5 * pi);
  double total = 0;
  for (int i = 0; i < nodes; ++i) {
    // tan(theta) = alpha tan(t); d theta / d t = alpha / (cos² t + alpha² sin² t).
    const double s = std::sin(rule.x[i]), c = std::cos(rule.x[i]);
    const double theta = std::atan2(alpha * s, c);
    const double stretch = alpha / (c * c + alpha * alpha * s * s);
    double ring = 0;
    for (int k = 0; k < azimuths; ++k)
      ring += f(direction(theta, 2 * pi * (k + 0.5) / azimuths));
    total += rule.w[i] * stretch * std::sin(theta) * ring * 2 * pi / azimuths;
  }
  return total;
}

double mean_over_square(int n, const std::function<double(vec2)>& f) {
  double total = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      total += f(vec2((i + 0.5) / n, (j + 0.5) / n));
  return total / n / n;
}

Energy single_scattering(double theta, double alpha, double eta, Smith smith) {
  const vec3 wo = direction(theta, 0.0);
  const Tilt o = f64::tilt(wo);
  const double g1 = f64::ggxG1(o, alpha);
  Energy energy;
  mean_over_square(energy_grid, [&](vec2 u) {
    const vec3 m = f64::ggxSampleVisible(wo, vec2(alpha), u);
    const double c = f64::dot(wo, m);
    const double share = 1.0 / energy_grid / energy_grid;
    const vec3 r = f64::reflectAbout(wo, m), t = f64::refractAbout(wo, m, eta);
    if (r.z > 0) {
      const Tilt i = f64::tilt(r);
      const double g2 =
          smith == Smith::separable ? f64::ggxG2(i, o, alpha) : f64::ggxG2Correlated(i, o, alpha);
      energy.reflected += share * f64::fresnelDielectricAt(c, eta) * g2 / g1;
    }
    if (t.z < 0) {
      const Tilt i = f64::tilt(t);
      const double g2 =
          smith == Smith::separable ? f64::ggxG2(i, o, alpha) : f64::ggxG2Beta(i, o, alpha);
      energy.transmitted += share * f64::fresnelTransmittedAt(c, eta) * g2 / g1;
    }
    return 0.0;
  });
  return energy;
}

double lossless_albedo(double theta, double alpha, Smith smith) {
  const vec3 wo = direction(theta, 0.0);
  const Tilt o = f64::tilt(wo);
  return mean_over_square(energy_grid, [&](vec2 u) {
    const vec3 r = f64::reflectAbout(wo, f64::ggxSampleVisible(wo, vec2(alpha), u));
    if (!(r.z > 0)) return 0.0;
    const Tilt i = f64::tilt(r);
    return smith == Smith::separable ? f64::ggxG1(i, alpha)
                                     : f64::ggxG2Correlated(i, o, alpha) / f64::ggxG1(o, alpha);
  });
}

} // namespace gg::bsdf_test
