#include "figures/curves.h"

#include "glsl/f64.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace gg::figures {
namespace {

using namespace glsl;
using f64::vec3;

using std::numbers::pi;
const vec3 normal(0.0, 0.0, 1.0);

// The light comes from the left.
vec3 light(double incidence) {
  return {-std::sin(incidence), 0.0, std::cos(incidence)};
}

f64::BsdfSurface surface(bool transmits, double alpha, double eta) {
  return {transmits, f64::BSDF_GGX, alpha, eta, 0.0, 0.0};
}

// f |o.n| in the plane of incidence, against the angle from the normal of the lobe's side.
std::vector<Point> in_plane(double incidence, double alpha, double eta, bool transmits) {
  const f64::BsdfSurface s = surface(transmits, alpha, eta);
  const double side = transmits ? -1.0 : 1.0;
  // A third of a degree: the narrowest lobe drawn is some ten degrees wide.
  return sampled(-0.5 * pi, 0.5 * pi, 540, [&](double angle) {
    const vec3 o(std::sin(angle), 0.0, side * std::cos(angle));
    return f64::bsdfValues(f64::bsdfFacet(o, light(incidence), normal, s), s).fCos;
  });
}

// The mean of o over the lobe; NaN where the lobe is empty. With f |o.n| dω_o = |i.m| / |i.n| rho G
// D dω_m the integral goes over facets, in slopes t = tan theta_m: D dω_m = alpha² / (pi (alpha² +
// t²)²) t dt dphi / cos theta_m. Rings at t = alpha (x / (1 - x))² give GGX's tail, which is all
// that transmits past the critical angle, a quarter of the points.
double mean_angle(double incidence, double alpha, double eta, bool transmits) {
  constexpr int rings = 160,
                spokes =
                    90; // twice as many of each move no mean direction by more than 0.05 degrees
  const vec3 i = light(incidence);
  double across = 0.0, along = 0.0;
  for (int ring = 0; ring < rings; ++ring) {
    const double x = (ring + 0.5) / rings, root = x / (1.0 - x), t = alpha * root * root;
    const double slopes = t / std::pow(alpha * alpha + t * t, 2) * root / ((1.0 - x) * (1.0 - x));
    for (int spoke = 0; spoke < spokes; ++spoke) { // half a turn: the other half mirrors it
      const double phi = pi * (spoke + 0.5) / spokes;
      const vec3 m = f64::normalize(vec3(t * std::cos(phi), t * std::sin(phi), 1.0));
      const double c = f64::dot(i, m);
      if (c <= 0.0) continue;
      const vec3 o = transmits ? f64::refractAbout(i, m, eta) : f64::reflectAbout(i, m);
      if (transmits ? o.z >= 0.0 : o.z <= 0.0) continue;
      const double share =
          transmits ? f64::fresnelTransmittedAt(c, eta) : f64::fresnelDielectricAt(c, eta);
      const double weight =
          slopes / m.z * c * share * f64::ggxG2(f64::tilt(i), f64::tilt(o), alpha);
      across += weight * o.x;
      along += weight * std::abs(o.z);
    }
  }
  return along > 0.0 ? std::atan2(across, along) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

double fresnel(double incidence, double eta, Polarization polarization) {
  const f64::Polarized r = f64::fresnelPolarizedAt(std::cos(incidence), eta);
  if (polarization == Polarization::s) return r.s;
  if (polarization == Polarization::p) return r.p;
  return f64::fresnelDielectricAt(std::cos(incidence), eta);
}

double fresnel_conductor(double incidence, double n, double k) {
  return f64::fresnelConductor(std::cos(incidence), n, k);
}

double distribution(Distribution which, double alpha, double theta) {
  const f64::Tilt m = f64::tilt(vec3(std::sin(theta), 0.0, std::cos(theta)));
  if (which == Distribution::ggx) return f64::ggxD(m, alpha);
  if (which == Distribution::beckmann) return f64::beckmannD(m, alpha);
  return f64::phongD(m, f64::phongExponent(alpha));
}

double shadowing(Distribution which, double alpha, double theta) {
  const f64::Tilt w = f64::tilt(vec3(std::sin(theta), 0.0, std::cos(theta)));
  if (which == Distribution::ggx) return f64::ggxG1(w, alpha);
  if (which == Distribution::beckmann) return f64::beckmannG1(w, alpha);
  return f64::phongG1(w, f64::phongExponent(alpha));
}

double mean_reflected(double incidence, double alpha, double eta) {
  return mean_angle(incidence, alpha, eta, false);
}

double mean_transmitted(double incidence, double alpha, double eta) {
  return mean_angle(incidence, alpha, eta, true);
}

Lobe reflected_lobe(double incidence, double alpha, double eta) {
  return {in_plane(incidence, alpha, eta, false), incidence, mean_reflected(incidence, alpha, eta)};
}

Lobe transmitted_lobe(double incidence, double alpha, double eta) {
  Lobe lobe{in_plane(incidence, alpha, eta, true), {}, mean_transmitted(incidence, alpha, eta)};
  const double sine = std::sin(incidence) / eta;
  if (sine < 1.0) lobe.ideal = std::asin(sine);
  return lobe;
}

std::vector<Point> sampled(double low, double high, int steps,
                           const std::function<double(double)>& f) {
  std::vector<Point> points;
  for (int step = 0; step <= steps; ++step) {
    const double x = low + (high - low) * step / steps;
    points.push_back({x, f(x)});
  }
  return points;
}

} // namespace gg::figures
