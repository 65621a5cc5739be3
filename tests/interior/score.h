// How near the search comes to ray casting.
#pragma once

#include "interior/probe.h"
#include "interior/walk.h"

#include <vector>

namespace gg::test {

inline constexpr double degree = 0.017453292519943295;

// Between two directions, radians.
double angle(const glm::dvec3& a, const glm::dvec3& b);
// 0 for no values; q in 0 .. 1.
double quantile(std::vector<double> values, double q);
// Of values up to the limit, %; 0 for no values.
double share_within(double limit, const std::vector<double>& values);
double mean(const std::vector<double>& values);

// Over the pixels whose way leaves the solid, in truth. One that the search did not finish counts as
// wrong by 180 degrees.
struct Score {
  std::vector<double> errors;            // of the final direction, radians
  std::vector<double> by_reflections[4]; // the same, by how many there were; the last: 3 and more
  std::vector<double> apart;             // of the ends of the first segment, metres
  std::vector<double> reads;             // places of the picture, of all pixels that show the solid
  double search_ms = 0.0, layers_ms = 0.0; // per picture, mean
  int pictures = 0;
  void add(const ProbeResult& found, const std::vector<Walk>& truth);
};

// Nothing that the search gives is NaN or infinite, and every normalised direction is.
bool is_sound(const ProbeResult& found);

} // namespace gg::test
