// Made-up environments with the contrasts of real ones, from seeds: what one-lobe Gaussians are fitted and tested on, so that
// the tables depend on nothing but the program.
#pragma once

#include "tables/sphere_map.h"

#include <string>
#include <vector>

namespace gg::tables {

struct TrainingMap {
  std::string name;
  SphereMap map;
};

// `draw` 0, 1: seen by the fits; 2, 3: held out. Families: clouds (1/f noise), sky with a sun, studio, night, windows,
// stripes, dark room; the held-out draws have two more that no fit has seen, canopy and horizon.
std::vector<TrainingMap> training_maps(int size, int draw);
inline constexpr int fitted_draws[] = {0, 1}, held_out_draws[] = {2, 3};

} // namespace gg::tables
