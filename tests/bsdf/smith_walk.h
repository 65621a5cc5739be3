// Light between the facets of a Smith surface with GGX's statistics, followed one random bounce at
// a time: an answer to what single scattering loses that shares no formula with G2 [Heitz16].
#pragma once

#include "glsl/f64.h"

#include <cstdint>

namespace gg::bsdf_test {

// What becomes of unit power that comes in along wo, by where it leaves and after how many facets.
struct WalkEnergy {
  double reflected_once = 0, transmitted_once = 0;
  double reflected_more = 0, transmitted_more = 0;
  double trapped = 0; // still inside after the longest walk
};

// A clear dielectric, eta = n_far / n_near with wo on the near side at cosine `cos_theta`; `walks`
// random walks. Each of the energies has a standard error below 0.5 / sqrt(walks).
WalkEnergy walk_dielectric(double cos_theta, double alpha, double eta, int walks,
                           std::uint64_t seed);

// The same for a surface that reflects everything, with the reflectance of each bounce
// `reflectance` (Schlick's f0 would vary with angle; a constant shows the sum over bounces).
// Returns the power that leaves.
double walk_mirror(double cos_theta, double alpha, double reflectance, int walks,
                   std::uint64_t seed);

} // namespace gg::bsdf_test
