// Makes the tables of one rough interface.
#pragma once

#include "tables/grid_fit.h"
#include "tables/interface_table.h"

namespace gg::tables {

// `step` is called by one thread at a time, as often as ..._steps() says.
InterfaceShares make_interface_energy_cell(const Model& model, int x, int y, int slice);
InterfaceEnergyTable make_interface_energy(const Model& model, const Step& step);
int interface_energy_steps();

// One node of the lobes' grid: what its gaussians are fitted to, empty where too little light gets through to tell.
GridCell interface_cell(const FitViews& views, const Model& model, int x, int y, int slice);
Grid interface_grid(const FitViews& views, const Model& model, const Step& step);
InterfaceLobeTable make_interface_lobes(const Model& model, const FitViews& views, const Grid& grid,
                                        int gaussians, const Step& step);
int interface_grid_steps();
int interface_lobe_steps();

} // namespace gg::tables
