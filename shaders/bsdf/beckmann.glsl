// beckmann.glsl: Beckmann's distribution of microfacet normals (Gaussian slopes) and Smith's shadowing for it.
// Frame    D, G1, V, pdf: any, by Tilt (half_vector.glsl). Sampler: local, n = +z.
// alpha    slope width (rms slope times sqrt 2), [0, 1] and beyond; at 0 a delta: D is 0, the sampler returns +z.
// Returns  beckmannD: 1/sr. beckmannG1 (Walter's rational fit), beckmannG2 (separable): [0, 1]. beckmannV: G2 /
//          (4 |wi.n| |wo.n|), finite. beckmannPdf: 1/sr. beckmannSample: unit wm, for u in [0, 1)².
// Source   [Walter07] eq. 25-29; the exact G1 is in beckmann_exact.glsl.
// Limits   the rational G1 is within 0.0032 of the exact one; it exceeds 1 by up to 7e-5 just before a = 1.6, where
//          it is cut.
#ifndef GG_BSDF_BECKMANN_GLSL
#define GG_BSDF_BECKMANN_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/half_vector.glsl"

// D = exp(-tan² / alpha²) / (pi alpha² cos⁴), as the square of exp(-x / 2) s / (alpha z²). Past x = 2000 exp(-x / 2)
// is below the smallest double: 0 exactly, and the horizon (z = 0) is answered by the same test.
float beckmannD(Tilt m, float alpha) {
  float width = alpha * m.z;
  float width2 = width * width;
  if (!(m.p < 2000.0 * width2)) return 0.0;
  float t = exp(-0.5 * m.p / width2) * alpha * (m.p + m.z * m.z) / width2;
  return t * t / BSDF_PI;
}

// 1 / a = alpha tan is r / z; numerator and denominator of the fit times r², so that neither z = 0 nor r = 0 divides.
float beckmannG1OverZ(Tilt w, float alpha) {
  float r = alpha * sqrt(w.p);
  float z = w.z;
  if (z >= 1.6 * r) return z > 0.0 ? 1.0 / z : 0.0;
  return (3.535 * r + 2.181 * z) / (r * r + 2.276 * r * z + 2.577 * z * z);
}

float beckmannG1(Tilt w, float alpha) { return beckmannG1OverZ(w, alpha) * w.z; }

float beckmannG2(Tilt wi, Tilt wo, float alpha) {
  return beckmannG1(wi, alpha) * beckmannG1(wo, alpha);
}

float beckmannV(Tilt wi, Tilt wo, float alpha) {
  return 0.25 * beckmannG1OverZ(wi, alpha) * beckmannG1OverZ(wo, alpha);
}

// Density of wm drawn by beckmannSample: D |wm . n|.
float beckmannPdf(Tilt m, float alpha) { return beckmannD(m, alpha) * tiltCos(m); }

// A normal with density D |wm . n|: tan² = -alpha² log(1 - u).
vec3 beckmannSample(float alpha, vec2 u) {
  float phi = 2.0 * BSDF_PI * u.y;
  float slope = alpha * sqrt(-log(1.0 - u.x));
  return normalize(vec3(slope * cos(phi), slope * sin(phi), 1.0));
}

#endif
