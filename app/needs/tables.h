// Which of the tables in assets/tables a scene's materials read.
#pragma once

#include "needs/draws.h"
#include "tables/lobe.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gg::needs {

enum class TableKind {
  reflection_energy,
  reflection_lobes,
  interface_energy,
  interface_lobes,
  wall_energy,
  wall_lobes
};

struct Table {
  TableKind kind;
  tables::Model model;
  int lobes = 0; // that it holds; 0: it is of energies
  std::string file;
  std::size_t bytes = 0; // on the device
};

// The tables of a material's lobe.
tables::Model model_of(const scene::Material& material, bool correlated_smith);

// Lobes of a method's tables: of one face's reflection, and of one face that light passes. What is composed of two faces
// needs two lobes of each at most (refraction/composition_fetch.glsl). 0: it reads none.
int reflection_lobes(Method method, const tables::Model& model);
int interface_lobes(Method method);

// Each once, in the order of tables::models.
std::vector<Table> tables_of(const std::vector<Draw>& draws, const View& view);

} // namespace gg::needs
