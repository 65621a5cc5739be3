// The tables against what is usual, on environments that no fit has seen: RMS log error over many lobes.
#pragma once

#include "tables/held_out.h"
#include "tables/interface_table.h"
#include "tables/reflection_table.h"

#include <map>
#include <string>

namespace gg::tables {

enum class Side { reflection, entering, leaving };

// Lobes: every alpha at every angle (degrees) and index (from 1 up; not for reflection). Of what leaves, lobes that carry
// less than `least_energy` are not scored: past the critical angle of nearly smooth glass nothing is seen.
struct Sweep {
  std::vector<double> alphas, angles, indices;
  static constexpr double least_energy = 0.02;
};
Sweep full_sweep();
Sweep short_sweep();

// Mean squares by method: "standard" (reflection: along the mirror direction, as wide as at normal incidence, split sum;
// transmission: along Snell's direction, or the surface past the critical angle, with the roughness that the Khronos viewer
// and three.js scale by index), "fis32" (32 filtered importance samples), "taps1" to as many as there are tables for (taps_of). All have the exact energy.
struct Scores {
  int lobes = 0;
  std::map<std::string, double> squares;          // all views
  std::map<std::string, double> squares_pictures; // views of photographed environments only
  double rms(const std::string& method) const;
  double gain(const std::string& method) const; // rms("standard") / rms(method)
};
Scores score(const Training& maps, const Model& model, Side side, const Sweep& sweep);

} // namespace gg::tables
