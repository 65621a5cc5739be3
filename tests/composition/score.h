// How far apart two lobes are, as what they show of environments that nothing was fitted to.
#pragma once

#include "composition/truth.h"
#include "tables/training.h"

#include <vector>

namespace gg::composition_test {

// One lookup of a Gaussian stack.
struct Lookup {
  glm::dvec3 direction{0.0};
  double sigma = 0.0;  // radians
  double weight = 0.0; // energy included
};

double energy_of(const std::vector<Lookup>& lobes);

// The held-out maps in many orientations. The first call says how fine they are, texels along a cube's edge: the narrowest
// lobes ask for 128, which take a while to blur.
const tables::Training& environments(int texels_per_edge = 64);

// The truth's radiance in every view, for energy 1.
std::vector<double> seen(const Truth& truth);

struct Score {
  double error =
      0.0; // root mean square of ln((lobes + f) / (truth + f)), f a fifth of the map's geometric mean and of the energy
  double shape = 0.0; // the same with the lobes given the truth's energy
};
Score score(const Truth& truth, const std::vector<double>& truth_seen,
            const std::vector<Lookup>& lobes);

// The least error that this many free lobes can have: the lobes given, improved by Levenberg and Marquardt's method.
std::vector<Lookup> fitted(const Truth& truth, const std::vector<double>& truth_seen,
                           std::vector<Lookup> start);

} // namespace gg::composition_test
