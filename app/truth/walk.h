// The paths of one sample: what they brought, and those that are still to be followed.
#pragma once

#include "truth/integrator.h"

#include <utility>
#include <vector>

namespace gg::truth {

// Directions to the environment that are looked at where a path gathers direct light.
inline constexpr int environment_candidates = 2;

struct Integrator::Walk {
  Random& random;
  Sample sample;
  std::vector<Path> paths; // on their way
  std::vector<std::pair<Path, Intersection>>
      at_surfaces; // scattered, and to be scattered there again
};

} // namespace gg::truth
