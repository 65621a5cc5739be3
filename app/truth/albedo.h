// How much of the light a rough surface that reflects everything sends on after one bounce: what is
// missing has met further facets.
#pragma once

#include "truth/closure.h"

#include <vector>

namespace gg::truth {

// Directional albedo e(cos theta, alpha) and its mean 2 int e c dc, tabulated once from samples.
// Within 0.005 of quadrature (tests/truth).
class Albedo {
public:
  Albedo(scene::Distribution distribution, Smith smith);

  double at(double cosine, double alpha) const; // both in [0, 1]
  double mean(double alpha) const;
  // [KullaConty17] eq. 11 for light that has bounced: the mean reflectance, once for the bounce that
  // single scattering lost and once for every further one.
  glm::dvec3 tint(const Interface& metal) const;

private:
  static constexpr int cosines = 33, widths = 17; // cos theta = t², t and alpha evenly spaced
  double node(int i, int k) const { return values_[static_cast<std::size_t>(k * cosines + i)]; }

  std::vector<double> values_, means_;
};

} // namespace gg::truth
