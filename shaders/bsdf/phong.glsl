// phong.glsl: the Phong distribution of microfacet normals, a power of the cosine, with Beckmann's shadowing.
// Frame    D, G1, V, pdf: any, by Tilt (half_vector.glsl). Sampler: local, n = +z.
// alpha    the snippets take Phong's exponent, >= 0; phongExponent converts a slope width alpha in (0, 1], phongAlpha
//          back.
// Returns  phongD: 1/sr. phongG1, phongG2: [0, 1]. phongV: G2 / (4 |wi.n| |wo.n|), finite. phongPdf: 1/sr.
//          phongSample: unit wm, for u in [0, 1)².
// Source   [Walter07] eq. 30-32 and the width match below them.
// Limits   D and G1 do not belong together, so energy is gained: of the facets' area wo sees 1.083 at alpha 0.5 and
//          85 degrees (up to 1.77 at alpha 1), and a surface that reflects everything returns 1.021 there, 1.34 at
//          worst (alpha 1 at the horizon); up to alpha 0.3 at most 1.04 and 1. tests/bsdf holds these. Exponent 0 is
//          alpha 1.
#ifndef GG_BSDF_PHONG_GLSL
#define GG_BSDF_PHONG_GLSL

#include "bsdf/beckmann.glsl"
#include "bsdf/log1p.glsl"

// 2 / alpha² - 2; wider than alpha = 1 the exponent stays 0, and alpha = 0 gives the largest that float32 squares.
float phongExponent(float alpha) {
  float a2 = max(alpha * alpha, 1e-18);
  return max(2.0 * (1.0 - a2) / a2, 0.0);
}

float phongAlpha(float exponent) { return sqrt(2.0 / (max(exponent, 0.0) + 2.0)); }

// D = (e + 2) / (2 pi) cos^e; cos^e = (1 + tan²)^(-e / 2), its log taken of 1 + tan² so that it is exact near the
// normal. tan² is kept finite, for the exponent 0: 0 times infinity is no power.
float phongD(Tilt m, float exponent) {
  float z2 = m.z * m.z;
  if (!(z2 > 0.0)) return 0.0;
  float tan2 = min(m.p / z2, 1e37);
  return (exponent + 2.0) / (2.0 * BSDF_PI) * exp(-0.5 * exponent * log1pPositive(tan2));
}

float phongG1(Tilt w, float exponent) { return beckmannG1(w, phongAlpha(exponent)); }

float phongG2(Tilt wi, Tilt wo, float exponent) { return beckmannG2(wi, wo, phongAlpha(exponent)); }

float phongV(Tilt wi, Tilt wo, float exponent) { return beckmannV(wi, wo, phongAlpha(exponent)); }

// Density of wm drawn by phongSample: D |wm . n|.
float phongPdf(Tilt m, float exponent) { return phongD(m, exponent) * tiltCos(m); }

// A normal with density D |wm . n|: cos^(e + 2) = 1 - u, and sin² from the same logarithm.
vec3 phongSample(float exponent, vec2 u) {
  float phi = 2.0 * BSDF_PI * u.y;
  float z = exp(log(1.0 - u.x) / (exponent + 2.0));
  float r = sqrt(max((1.0 - z) * (1.0 + z), 0.0));
  return vec3(r * cos(phi), r * sin(phi), z);
}

#endif
