#include "truth/microfacets.h"

#include "truth/beckmann_visible.h"

namespace gg::truth {

namespace f64 = glsl::f64;
using scene::Distribution;

double Microfacets::density(const Pair& p) const {
  if (widths_) return f64::ggxAnisoD(p.h, *widths_);
  const Facet& f = p.facet;
  switch (distribution_) {
  case Distribution::beckmann:
    return f64::beckmannD(f.h, alpha_);
  case Distribution::phong:
    return f64::phongD(f.h, f64::phongExponent(alpha_));
  case Distribution::ggx:
    break;
  }
  return f64::ggxD(f.h, alpha_);
}

namespace {

// Lambda of the distribution; Phong borrows Beckmann's at the matched width, as for its G1.
double lambda(Distribution distribution, const f64::Tilt& w, double alpha) {
  return distribution == Distribution::ggx ? f64::ggxLambda(w, alpha)
                                           : f64::beckmannLambdaExact(w, alpha);
}

// G2 / (4 cos cos); on the horizon, where nothing arrives or leaves, 0.
double over_cosines(double g2, const Microfacets::Facet& f) {
  const double cosines = 4.0 * f.wi.z * f.wo.z;
  return cosines > 0.0 ? g2 / cosines : 0.0;
}

double separable(Distribution distribution, const Microfacets::Facet& f, double alpha) {
  switch (distribution) {
  case Distribution::beckmann:
    return f64::beckmannV(f.wi, f.wo, alpha);
  case Distribution::phong:
    return f64::phongV(f.wi, f.wo, f64::phongExponent(alpha));
  case Distribution::ggx:
    break;
  }
  return f64::ggxV(f.wi, f.wo, alpha);
}

} // namespace

double Microfacets::shadowing_reflected(const Pair& p) const {
  if (widths_)
    return smith_ == Smith::separable ? f64::ggxAnisoV(p.wi, p.wo, *widths_)
                                      : f64::ggxAnisoVCorrelated(p.wi, p.wo, *widths_);
  const Facet& f = p.facet;
  if (smith_ == Smith::separable) return separable(distribution_, f, alpha_);
  if (distribution_ == Distribution::ggx) return f64::ggxVCorrelated(f.wi, f.wo, alpha_);
  const double sum = lambda(distribution_, f.wi, alpha_) + lambda(distribution_, f.wo, alpha_);
  return over_cosines(1.0 / (1.0 + sum), f);
}

double Microfacets::shadowing_transmitted(const Pair& p) const {
  const Facet& f = p.facet;
  if (widths_)
    return smith_ == Smith::separable
               ? f64::ggxAnisoV(p.wi, p.wo, *widths_)
               : over_cosines(f64::smithG2Beta(f64::ggxAnisoLambda(p.wi, *widths_),
                                               f64::ggxAnisoLambda(p.wo, *widths_)),
                              f);
  if (smith_ == Smith::separable) return separable(distribution_, f, alpha_);
  return over_cosines(
      f64::smithG2Beta(lambda(distribution_, f.wi, alpha_), lambda(distribution_, f.wo, alpha_)),
      f);
}

glm::dvec3 Microfacets::sample(const glm::dvec3& wo, Random& random) const {
  if (smooth()) return {0.0, 0.0, 1.0};
  switch (distribution_) {
  case Distribution::beckmann:
    return beckmann_sample_visible(wo, alpha_, random);
  case Distribution::phong:
    return f64::phongSample(f64::phongExponent(alpha_), random.uniform2());
  case Distribution::ggx:
    break;
  }
  return f64::ggxSampleVisible(wo, widths_.value_or(glm::dvec2(alpha_)), random.uniform2());
}

double Microfacets::pdf(const Pair& p) const {
  const Facet& f = p.facet;
  if (!f.exists) return 0.0;
  if (widths_) return f64::ggxAnisoPdfVisible(f, p.h, p.wo, *widths_);
  switch (distribution_) {
  case Distribution::beckmann:
    return beckmann_pdf_visible(f, alpha_);
  case Distribution::phong:
    return f64::phongPdf(f.h, f64::phongExponent(alpha_));
  case Distribution::ggx:
    break;
  }
  return f64::ggxPdfVisible(f, alpha_);
}

} // namespace gg::truth
