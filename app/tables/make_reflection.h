// Makes the tables of the reflection lobe.
#pragma once

#include "tables/energy.h"
#include "tables/grid_fit.h"
#include "tables/reflection_table.h"

namespace gg::tables {

// `step` is called by one thread at a time, as often as ..._steps() says.
EnergyCell make_reflection_energy_cell(const Model& model, int x, int y);
ReflectionEnergyTable make_reflection_energy(const Model& model, const Step& step);
int reflection_energy_steps();

// One node of the lobes' grid: what its gaussians are fitted to.
GridCell reflection_cell(const FitViews& views, const Model& model, int x, int y, int slice);
Grid reflection_grid(const FitViews& views, const Model& model, const Step& step);
ReflectionLobeTable make_reflection_lobes(const Model& model, const FitViews& views,
                                          const Grid& grid, int gaussians, const Step& step);
int reflection_grid_steps();
int reflection_lobe_steps();

} // namespace gg::tables
