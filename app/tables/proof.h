// The tables against what is usual, on environments that no fit has seen: RMS log error over many lobes, one point and one
// environment each, lookups as the shaders make them.
#pragma once

#include "tables/held_out.h"
#include "tables/interface_table.h"
#include "tables/reflection_table.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace gg {
class Progress;
}

namespace gg::tables {

enum class Side { reflection, entering, leaving };

// Lobes: every alpha at every angle (degrees) and index (from 1 up; not for reflection). Of what leaves, lobes that carry
// less than `least_energy` are not scored: past the critical angle of nearly smooth glass nothing is seen.
struct Sweep {
  std::vector<double> alphas, angles, indices;
  static constexpr double least_energy = 0.02;
};
// The study's lobes: alpha .02 to .8; reflected at up to 85 degrees, entering at up to 82, leaving at up to 55.
Sweep study_sweep(Side side);
// What leaves at 70 and 82 degrees besides, where a band along the horizon is left of it.
Sweep leaving_to_grazing();
Sweep short_sweep();

// Mean squares by method. "standard" is the usual approximation: a map prefiltered by GGX's lobe at normal incidence (n = v = r), here
// exactly, read along the mirror direction; or along Snell's (the surface, past the critical angle) with the roughness that
// the Khronos viewer and three.js scale by index. "gaussian": the same directions, the best single Gaussian instead of
// GGX's. "fis32": 32 filtered importance samples. "lobes1" to as many as there are tables for (lobes_of). All have the
// exact energy.
struct Scores {
  int lobes = 0;
  std::map<std::string, double> squares;          // all views
  std::map<std::string, double> squares_pictures; // views of photographed environments only
  double rms(const std::string& method) const;
  double rms_pictures(const std::string& method) const;
  double gain(const std::string& method) const; // rms("standard") / rms(method)
  double gain_pictures(const std::string& method) const;
};
Scores score(const Training& maps, const Model& model, Side side, const Sweep& sweep);

// The whole proof, as a table in Markdown: a row for every model and lobe.
struct ProofRow {
  Model model;
  Side side = Side::reflection;
  std::string lobes; // what is scored
  Scores scores;
};
int proof_rows();
std::vector<ProofRow> prove(Progress& progress); // proof_rows() steps
std::string proof_table(const std::vector<ProofRow>& rows);

} // namespace gg::tables
