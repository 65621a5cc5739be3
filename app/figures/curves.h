// The numbers behind the figures, from the snippets of shaders/bsdf in double.
#pragma once

#include "figures/canvas.h"
#include "figures/polar.h"

#include <functional>
#include <vector>

namespace gg::figures {

// Angles in radians; relative indices are far side over the side of the light.

enum class Polarization { s, p, mean };
double fresnel(double incidence, double eta, Polarization polarization);
double fresnel_conductor(double incidence, double n, double k);

enum class Distribution { ggx, beckmann, phong };
// D in 1/sr and G1, for the slope width alpha (Phong's exponent is the one that matches it).
double distribution(Distribution which, double alpha, double theta);
double shadowing(Distribution which, double alpha, double theta);

// One side of what an interface of GGX width alpha does with light from `incidence`: f in the plane
// of incidence, the direction of a smooth interface, and the mean direction over the whole lobe,
// weighted by f |o.n|.
Lobe reflected_lobe(double incidence, double alpha, double eta);
Lobe transmitted_lobe(double incidence, double alpha, double eta);
// The mean directions alone; the angle from the normal, on the lobe's own side.
double mean_reflected(double incidence, double alpha, double eta);
double mean_transmitted(double incidence, double alpha, double eta);

// y = f(x) at so many steps from low to high, with x as it is given to f.
std::vector<Point> sampled(double low, double high, int steps,
                           const std::function<double(double)>& f);

} // namespace gg::figures
