// beckmann_exact.glsl: Smith's shadowing for Beckmann's distribution with the error function, exact.
// Frame    any, by Tilt (half_vector.glsl).
// alpha    slope width, [0, 1] and beyond; 0 shadows nothing.
// Returns  beckmannLambdaExact: >= 0, 1e30 at the horizon; beckmannG1Exact: [0, 1].
// Source   [Walter07] eq. 26; [Heitz14] eq. 66; erf by [AS64] 7.1.6 (series) and 7.1.14 (continued fraction).
// Limits   absolute error of G1 below 2e-14 in double, 2e-7 in float; a loop of 30 steps, so for tables and proofs
//          rather than for every pixel: beckmann.glsl has the rational form.
#ifndef GG_BSDF_BECKMANN_EXACT_GLSL
#define GG_BSDF_BECKMANN_EXACT_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/half_vector.glsl"

// a (1 + Lambda), finite down to a = 0, for a = 1 / (alpha tan). 2 Lambda = erf(a) - 1 + exp(-a²) / (a sqrt pi).
// Below a = 2 erf is 2 a exp(-a²) / sqrt pi times the sum of (2 a²)^n / (2 n + 1)!!, all terms positive; above, 1 -
// erf is exp(-a²) / (sqrt pi (a + K)) with a continued fraction K, and the difference that Lambda is, 1 / a - 1 / (a
// + K), is K / (a (a + K)). 30 terms leave less than 2e-14 on both sides.
float beckmannAPlus(float a) {
  if (a < 2.0) {
    float a2 = a * a;
    float term = 1.0;
    float sum = 1.0;
    for (int n = 1; n < 30; ++n) {
      term *= 2.0 * a2 / float(2 * n + 1);
      sum += term;
    }
    return 0.5 * a + exp(-a2) * (0.5 + a2 * sum) / sqrt(BSDF_PI);
  }
  float k = 0.0;
  for (int n = 30; n > 0; --n) k = 0.5 * float(n) / (a + k);
  return a + 0.5 * exp(-a * a) / sqrt(BSDF_PI) * k / (a + k);
}

float beckmannG1Exact(Tilt w, float alpha) {
  float r = alpha * sqrt(w.p);
  // Past a = 7 Lambda is below 1e-24: nothing that either precision can add to 1.
  if (w.z >= 7.0 * r) return w.z > 0.0 ? 1.0 : 0.0;
  float a = w.z / r;
  return a / beckmannAPlus(a);
}

float beckmannLambdaExact(Tilt w, float alpha) {
  float g1 = beckmannG1Exact(w, alpha);
  return g1 > LEAST_DIVISOR ? 1.0 / g1 - 1.0 : 1e30; // where G1 underflows
}

#endif
