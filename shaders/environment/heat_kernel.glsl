// heat_kernel.glsl: the Gaussian of the sphere, exp(-l(l+1) variance / 2) in every spherical harmonic of degree l.
// Frame    any.
// alpha    none. variance: sigma² in rad², per axis of the tangent plane.
// Returns  heatKernel: the kernel at a point whose angle θ < 1 to the centre has chord2 = (2 sin(θ/2))², times a constant.
// Source   [MinakPleijel49], first term: exp(-θ²/(2 v)) sqrt(θ / sin θ).
// Limits   Within 2 % of itself at 4 sigma for sigma <= 0.25, where it is 3e-4 of its peak.
//          Wider ones are summed as Legendre series on the host (app/environment/zonal.h).
#ifndef GG_ENVIRONMENT_HEAT_KERNEL_GLSL
#define GG_ENVIRONMENT_HEAT_KERNEL_GLSL

// Where sums over a lattice end, in sigma, and the variance of a plane's Gaussian that is cut off there, relative to the
// whole one's: 1 - x exp(-x) / (1 - exp(-x)), x = reach² / 2. A kernel that is wider by its inverse makes up for it.
const float HEAT_KERNEL_REACH = 3.0;
const float HEAT_KERNEL_KEPT = 0.949448;

// θ² = 4 asin²(chord / 2) = c² + c⁴/12 + c⁶/90 + ..., sqrt(θ / sin θ) = exp(θ²/12 + ...).
float heatKernel(float chord2, float inverseTwiceVariance) {
  float theta2 = chord2 * (1.0 + chord2 * (1.0 / 12.0 + chord2 * (1.0 / 90.0)));
  return exp(theta2 * (1.0 / 12.0 - inverseTwiceVariance));
}

#endif
