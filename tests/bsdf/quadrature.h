// Integrals over directions, by rules whose error is stated.
#pragma once

#include "bsdf/distributions.h"

namespace gg::bsdf_test {

// Gauss-Legendre nodes and weights on [a, b].
struct Rule {
  std::vector<double> x, w;
};
Rule gauss_legendre(int n, double a, double b);

// Integral over the sphere of f(wm) where f is peaked about +z like a lobe of slope width alpha:
// Gauss-Legendre in t = atan(tan(theta) / alpha), which spreads the peak evenly, over the upper
// half; azimuth by the midpoint rule, exact for what varies with phi slowly.
double integrate_about_normal(double alpha, int nodes, int azimuths,
                              const std::function<double(vec3)>& f);

// Mean of f over the midpoints of an n x n grid on the unit square.
double mean_over_square(int n, const std::function<double(vec2)>& f);

// Single-scattering energies of wo at theta (radians), GGX, by visible normals on a grid: R1 and T1
// of a dielectric.
enum class Smith { separable, correlated };
struct Energy {
  double reflected = 0, transmitted = 0;
  double lost() const { return 1.0 - reflected - transmitted; }
};
Energy single_scattering(double theta, double alpha, double eta, Smith smith);
// The same for a surface that reflects everything.
double lossless_albedo(double theta, double alpha, Smith smith);

// The grid's error in these energies: halving its step moves none of them by more than this.
constexpr double grid_error = 4e-4;

} // namespace gg::bsdf_test
