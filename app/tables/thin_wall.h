// A thin wall, two equal rough interfaces at no distance: paths through both, the tables that come of them.
#pragma once

#include "tables/grid_fit.h"
#include "tables/thin_wall_table.h"

#include <vector>

namespace gg::tables {

// What a wall does with the light of one direction, all orders of reflection inside: shares of the power, and the
// transmitted directions (local frame as in lobe.h; each stands for as much of the lobe's solid angle as any other).
struct WallLight {
  InterfaceShares shares;
  std::vector<LobeSample> transmitted;
};
// `eta` > 1 of the wall over its surroundings; `count` paths, each followed until less than 1e-4 of it is left inside.
WallLight through_wall(const Model& model, double alpha, double cos_theta, double eta, int count);

// All cells: the energies, and what taps are fitted to.
struct WallGrid {
  ThinWallTable energy;
  Grid grid;
};
WallGrid thin_wall_grid(const FitViews& views, const Model& model, const Step& step);
ThinWallTable make_thin_wall_lobes(const Model& model, const FitViews& views, const Grid& grid,
                                   int taps, const Step& step);
int thin_wall_grid_steps();
int thin_wall_lobe_steps();

} // namespace gg::tables
