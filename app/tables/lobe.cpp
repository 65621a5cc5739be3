#include "tables/lobe.h"

#include "glsl/f64.h"

#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

using namespace gg::glsl::f64;

struct Draw {
  vec3 wm;
  double over_density; // weight of wm's mirror direction times the number of samples
  double pdf;          // of wi, 1/sr
};

// GGX by its visible normals: f cos / pdf is G2 / G1(wo), with wo's cosine divided out on paper.
Draw draw_ggx(Smith smith, double alpha, const vec3& wo, vec2 u) {
  Draw d;
  d.wm = ggxSampleVisible(wo, vec2(alpha, alpha), u);
  const vec3 wi = reflectAbout(wo, d.wm);
  const Facet f = reflectionFacet(wi, wo, vec3(0, 0, 1), 1.5);
  const double root_o = ggxRoot(f.wo, alpha), root_i = ggxRoot(f.wi, alpha);
  d.over_density = smith == Smith::separable
                       ? 2.0 * f.wi.z / (f.wi.z + root_i)
                       : f.wi.z * (f.wo.z + root_o) / (root_i * f.wo.z + root_o * f.wi.z);
  d.pdf = ggxPdfVisible(f, alpha) * reflectionJacobian(f);
  return d;
}

// Beckmann and Phong by D |wm . n|: f cos / pdf = 4 V |wo . wm| |wi . n| / |wm . n|.
Draw draw_other(Distribution distribution, double alpha, const vec3& wo, vec2 u) {
  const double exponent = phongExponent(alpha);
  Draw d;
  d.wm =
      distribution == Distribution::beckmann ? beckmannSample(alpha, u) : phongSample(exponent, u);
  const double facing = dot(wo, d.wm);
  if (!(facing > 0.0)) {
    d.over_density = d.pdf = 0.0;
    return d;
  }
  const vec3 wi = reflectAbout(wo, d.wm);
  const Facet f = reflectionFacet(wi, wo, vec3(0, 0, 1), 1.5);
  const double v = distribution == Distribution::beckmann ? beckmannV(f.wi, f.wo, alpha)
                                                          : phongV(f.wi, f.wo, exponent);
  d.over_density = 4.0 * v * facing * wi.z / d.wm.z;
  d.pdf =
      (distribution == Distribution::beckmann ? beckmannPdf(f.h, alpha) : phongPdf(f.h, exponent))
      / (4.0 * facing);
  return d;
}

} // namespace

std::string name(const Model& model) {
  const char* distribution = model.distribution == Distribution::ggx        ? "ggx"
                             : model.distribution == Distribution::beckmann ? "beckmann"
                                                                            : "phong";
  return std::string(distribution)
         + (model.smith == Smith::separable ? "-separable" : "-correlated");
}

std::vector<LobeSample> reflection_lobe(const Model& model, double alpha, double cos_theta,
                                        Walk walk, int count) {
  const vec3 wo(std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta)), 0.0, cos_theta);
  const int points = walk == Walk::grid ? count * count : count;
  std::vector<LobeSample> samples;
  samples.reserve(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    // `azimuth` turns about the normal (distribution sampling) or about the view (visible normals); half a turn is
    // enough where only energies are asked for.
    double azimuth, radius, share = 1.0 / points;
    if (walk == Walk::grid) {
      // Radii crowd towards 1, where GGX keeps the far tail of its normals: a share alpha² of them leans by more than
      // 45 degrees, whose mirror directions are below the horizon.
      const double low = static_cast<double>(i / count) / count, high = low + 1.0 / count;
      azimuth = 0.5 * (i % count + 0.5) / count;
      radius = 1.0 - std::pow(0.5 * (low + high), 3.0);
      share = (std::pow(high, 3.0) - std::pow(low, 3.0)) / count;
    } else {
      azimuth = (i + 0.5) * (std::numbers::phi - 1.0);
      azimuth -= std::floor(azimuth);
      radius = (i + 0.5) / count;
    }
    const Draw d = model.distribution == Distribution::ggx
                       ? draw_ggx(model.smith, alpha, wo, vec2(azimuth, radius))
                       : draw_other(model.distribution, alpha, wo, vec2(radius, azimuth));
    const vec3 wi = reflectAbout(wo, d.wm);
    if (!(wi.z > 0.0 && d.over_density > 0.0)) continue;
    samples.push_back({wi, dot(wo, d.wm), d.over_density * share, d.pdf / share});
  }
  return samples;
}

} // namespace gg::tables
