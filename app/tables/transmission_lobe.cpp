// Facets drawn, and what each sends through the interface.
#include "glsl/f64.h"
#include "tables/facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

using namespace gg::glsl::f64;
const vec3 up(0, 0, 1);

// Density of draw_facet.
double facet_density(const Model& model, double alpha, const Facet& f) {
  switch (model.distribution) {
  case Distribution::ggx:
    return ggxPdfVisible(f, alpha);
  case Distribution::beckmann:
    return beckmannPdf(f.h, alpha);
  default:
    return phongPdf(f.h, phongExponent(alpha));
  }
}

vec3 direction_of(double cos_theta) {
  return {std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta)), 0.0, cos_theta};
}

double weighted_median(std::vector<std::pair<double, double>>& value_and_weight) {
  std::ranges::sort(value_and_weight);
  double total = 0.0, sum = 0.0;
  for (const auto& [value, weight] : value_and_weight)
    total += weight;
  for (const auto& [value, weight] : value_and_weight)
    if ((sum += weight) >= 0.5 * total) return value;
  return 0.0;
}

} // namespace

vec3 draw_facet(const Model& model, double alpha, const vec3& wo, double azimuth, double radius) {
  switch (model.distribution) {
  case Distribution::ggx:
    return ggxSampleVisible(wo, vec2(alpha, alpha), vec2(azimuth, radius));
  case Distribution::beckmann:
    return beckmannSample(alpha, vec2(radius, azimuth));
  default:
    return phongSample(phongExponent(alpha), vec2(radius, azimuth));
  }
}

double passed(const Model& model, double alpha, const vec3& wo, const vec3& wi, const vec3& wm) {
  const Tilt i = tilt(wi), o = tilt(wo);
  if (model.distribution == Distribution::ggx) {
    const double root_o = ggxRoot(o, alpha), root_i = ggxRoot(i, alpha);
    if (model.smith == Smith::separable) return 2.0 * i.z / (i.z + root_i);
    if (wi.z > 0.0) return i.z * (o.z + root_o) / (root_i * o.z + root_o * i.z);
    const double lambda_o = ggxLambda(o, alpha);
    return smithG2Beta(ggxLambda(i, alpha), lambda_o) * (1.0 + lambda_o);
  }
  const double v = model.distribution == Distribution::beckmann
                       ? beckmannV(i, o, alpha)
                       : phongV(i, o, phongExponent(alpha));
  return 4.0 * v * dot(wo, wm) * i.z / wm.z;
}

std::vector<LobeSample> transmission_lobe(const Model& model, double alpha, double cos_theta,
                                          double eta, int count) {
  const vec3 wo = direction_of(cos_theta);
  std::vector<LobeSample> samples;
  for (int points = count;;) {
    samples.clear();
    for (int k = 0; k < points; ++k) {
      double azimuth = (k + 0.5) * (std::numbers::phi - 1.0);
      azimuth -= std::floor(azimuth);
      // radius = 1 - (1 - u)²: the lattice's weight follows.
      const double inner = 1.0 - (k + 0.5) / points, share = 2.0 * inner / points;
      const vec3 wm = draw_facet(model, alpha, wo, azimuth, 1.0 - inner * inner);
      const double facing = dot(wo, wm);
      if (!(facing > 0.0)) continue;
      const vec3 wi = refractAbout(wo, wm, eta);
      const double through = fresnelTransmitted(facing, fresnelG(facing, eta), eta);
      if (!(wi.z < 0.0 && through > 0.0)) continue;
      const Facet f = transmissionFacet(wi, wo, up, eta);
      const double density = facet_density(model, alpha, f) * transmissionJacobian(f, eta);
      if (!(density > 0.0)) continue;
      samples.push_back(
          {wi, facing, share * through * passed(model, alpha, wo, wi, wm), density / share});
    }
    const int most = 32 * count, found = static_cast<int>(samples.size());
    if (2 * found >= count || points == most) return samples;
    points = static_cast<int>(
        std::min<double>(most, static_cast<double>(points) * count / std::max(found, 1)));
  }
}

InterfaceShares interface_shares(const Model& model, double alpha, double cos_theta, double eta,
                                 int count) {
  const vec3 wo = direction_of(cos_theta);
  InterfaceShares shares;
  for (int ring = 0; ring < count; ++ring) {
    // Rings crowd towards facets that lean far, as in reflection_lobe.
    const double low = static_cast<double>(ring) / count, high = low + 1.0 / count;
    const double radius = 1.0 - std::pow(0.5 * (low + high), 3.0);
    const double share = (std::pow(high, 3.0) - std::pow(low, 3.0)) / count;
    for (int spoke = 0; spoke < count; ++spoke) {
      const vec3 wm = draw_facet(model, alpha, wo, 0.5 * (spoke + 0.5) / count, radius);
      const double facing = dot(wo, wm);
      if (!(facing > 0.0)) continue;
      const double through = fresnelTransmitted(facing, fresnelG(facing, eta), eta);
      const vec3 back = reflectAbout(wo, wm);
      if (back.z > 0.0)
        shares.reflected += share * (1.0 - through) * passed(model, alpha, wo, back, wm);
      if (!(through > 0.0)) continue;
      const vec3 on = refractAbout(wo, wm, eta);
      if (on.z < 0.0) shares.transmitted += share * through * passed(model, alpha, wo, on, wm);
    }
  }
  return shares;
}

LobeShape shape_of(const std::vector<LobeSample>& lobe) {
  std::vector<std::pair<double, double>> values;
  for (const LobeSample& s : lobe)
    values.push_back({std::atan2(-s.wi.x, std::abs(s.wi.z)), s.weight});
  LobeShape shape;
  shape.angle = weighted_median(values);
  const glm::dvec2 centre(std::sin(shape.angle), std::cos(shape.angle));
  values.clear();
  for (const LobeSample& s : lobe) {
    const double along = std::abs(s.wi.z);
    const glm::dvec3 apart(-s.wi.x - centre.x, s.wi.y, along - centre.y);
    values.push_back({2.0 * std::asin(std::min(0.5 * glm::length(apart), 1.0)), s.weight});
  }
  shape.width = weighted_median(values);
  return shape;
}

} // namespace gg::tables
