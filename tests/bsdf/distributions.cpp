#include "bsdf/distributions.h"

namespace gg::bsdf_test {

Distribution ggx(double alpha) {
  return {.name = "ggx",
          .alpha = alpha,
          .d = [=](Tilt m) { return f64::ggxD(m, alpha); },
          .g1 = [=](Tilt w) { return f64::ggxG1(w, alpha); },
          .pdf = [=](Tilt m) { return f64::ggxPdf(m, alpha); },
          .v = [=](Tilt i, Tilt o) { return f64::ggxV(i, o, alpha); },
          .sample = [=](vec2 u) { return f64::ggxSample(alpha, u); }};
}

Distribution beckmann(double alpha) {
  return {.name = "beckmann",
          .alpha = alpha,
          .d = [=](Tilt m) { return f64::beckmannD(m, alpha); },
          .g1 = [=](Tilt w) { return f64::beckmannG1(w, alpha); },
          .pdf = [=](Tilt m) { return f64::beckmannPdf(m, alpha); },
          .v = [=](Tilt i, Tilt o) { return f64::beckmannV(i, o, alpha); },
          .sample = [=](vec2 u) { return f64::beckmannSample(alpha, u); }};
}

Distribution phong(double alpha) {
  const double exponent = f64::phongExponent(alpha);
  return {.name = "phong",
          .alpha = alpha,
          .d = [=](Tilt m) { return f64::phongD(m, exponent); },
          .g1 = [=](Tilt w) { return f64::phongG1(w, exponent); },
          .pdf = [=](Tilt m) { return f64::phongPdf(m, exponent); },
          .v = [=](Tilt i, Tilt o) { return f64::phongV(i, o, exponent); },
          .sample = [=](vec2 u) { return f64::phongSample(exponent, u); }};
}

std::vector<Distribution> distributions(std::vector<double> alphas) {
  std::vector<Distribution> all;
  for (double alpha : alphas) {
    all.push_back(ggx(alpha));
    all.push_back(beckmann(alpha));
    if (alpha <= 1.0) all.push_back(phong(alpha));
  }
  return all;
}

vec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double reflected(const Distribution& m, vec3 wi, vec3 wo, double eta) {
  const Facet f = f64::reflectionFacet(wi, wo, up, eta);
  return f64::reflectionF(f, m.d(f.h), m.v(f.wi, f.wo), eta);
}

double transmitted(const Distribution& m, vec3 wi, vec3 wo, double eta) {
  const Facet f = f64::transmissionFacet(wi, wo, up, eta);
  return f64::transmissionF(f, m.d(f.h), m.v(f.wi, f.wo), eta);
}

} // namespace gg::bsdf_test
