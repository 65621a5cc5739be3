// Which pairs of interfaces are compared.
#pragma once

#include "composition/truth.h"

namespace gg::composition_test {

// Less light than this is only held to the right energy: its shape is what brute force leaves of it.
constexpr double dark = 0.02;

// Slabs, solid spheres, wedges of 5 to 45 degrees in the plane of incidence and across it, and curved exits; eta 1.33, 1.5, 2;
// theta 0 to 80; alphas of 0, .02, .1, .25, .5, not both 0. 540 drawn from the product, the same on every machine.
std::vector<Configuration> configurations(const tables::Model& model);

// The angle of incidence at the exit of the ray that Snell's law sends there, less the critical angle; degrees.
double past_critical(const Configuration& c);

} // namespace gg::composition_test
