// A thin wall, two equal rough interfaces at no distance: paths through both, the tables that come of them.
#pragma once

#include "tables/grid_fit.h"
#include "tables/thin_wall_table.h"

#include <vector>

namespace gg::tables {

// What a wall does with the light of one direction, all orders of reflection inside: shares of the power, and the
// directions of what gets through (local frame as in lobe.h; each stands for as much of the lobe's solid angle as any other).
struct WallLight {
  double transmitted = 0.0;
  double reflected_first = 0.0; // by the face that the light meets first
  double reflected_later = 0.0; // what comes back through it
  std::vector<LobeSample> directions;
  std::vector<LobeSample> returned; // the same of what comes back from within, towards +z
};
// `eta` > 1 of the wall over its surroundings; `count` paths, each followed until less than 1e-4 of it is left inside.
WallLight through_wall(const Model& model, double alpha, double cos_theta, double eta, int count);

// All cells: the energies, and what lobes are fitted to.
struct WallGrid {
  ThinWallTable energy;
  Grid grid;
};
WallGrid thin_wall_grid(const FitViews& views, const Model& model, const Step& step);
ThinWallTable make_thin_wall_lobes(const Model& model, const FitViews& views, const Grid& grid,
                                   int lobes, const Step& step);
int thin_wall_grid_steps();
int thin_wall_lobe_steps();

} // namespace gg::tables
