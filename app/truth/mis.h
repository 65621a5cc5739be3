// Multiple importance sampling of two densities [Veach97, 9.2].
#pragma once

namespace gg::truth {

// The power heuristic [Veach97, 9.2.4] for one sample of density a against one of density b.
inline double mis_share(double a, double b) {
  // By the ratio: a delta-like density does not overflow when it is squared.
  const double r = b / a;
  return 1.0 / (1.0 + r * r);
}

} // namespace gg::truth
