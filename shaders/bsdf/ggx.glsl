// ggx.glsl: the GGX (Trowbridge-Reitz) distribution of microfacet normals and Smith's shadowing for it.
// Frame    D, Lambda, G1, G2, V, pdfs: any, by Tilt (half_vector.glsl). Samplers: local, n = +z on wo's side.
// alpha    slope width, [0, 1] and beyond; at 0 the lobe is a delta and D, its finite part, is 0 (samplers return +z).
// Returns  ggxD: 1/sr, >= 0. ggxLambda: >= 0. ggxG1, ggxG2...: [0, 1]. ggxV...: G2 / (4 |wi.n| |wo.n|), finite.
//          ggxPdf...: 1/sr. Samplers: unit wm on the upper side, for u in [0, 1)².
// Source   [Walter07] eq. 33-36; [Heitz14] eq. 99 (correlated); [Dupuy23] alg. 1 (visible normals).
//          Transmission's Beta form of G2 is in smith_beta.glsl.
// Limits   D does not vanish at the horizon (alpha² / pi), so lobes end in a step there. float32 holds alpha >= 1e-4:
//          D is as exact as the Tilt that it is given, to 1e-6.
#ifndef GG_BSDF_GGX_GLSL
#define GG_BSDF_GGX_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/half_vector.glsl"

// D = t² / pi with t = alpha s / (p + alpha² z²): the ratio before the square, so that neither the peak (1 / alpha²)
// nor the tail (alpha²) leaves float32's range half-way.
float ggxD(Tilt m, float alpha) {
  float width = alpha * m.z;
  float spread = m.p + width * width;
  if (!(spread > 0.0 && alpha > 0.0)) return 0.0;
  float t = alpha * (m.p + m.z * m.z) / spread;
  return t * t / BSDF_PI;
}

// sqrt(z² + alpha² p) of a direction: (1 + 2 Lambda) z without the division.
float ggxRoot(Tilt w, float alpha) { return sqrt(w.z * w.z + alpha * alpha * w.p); }

// Lambda = (sqrt(1 + alpha² tan²) - 1) / 2, its subtraction expanded. Unbounded towards the horizon; there (z = 0)
// 1e30.
float ggxLambda(Tilt w, float alpha) {
  float slope = alpha * alpha * w.p;
  float below = 2.0 * w.z * (w.z + ggxRoot(w, alpha));
  return slope < 1e30 * below ? slope / below : 1e30;
}

float ggxG1(Tilt w, float alpha) {
  float sum = w.z + ggxRoot(w, alpha);
  return sum > 0.0 ? 2.0 * w.z / sum : 0.0;
}

// Separable: shadowing and masking independent. The reference model [Walter07].
float ggxG2(Tilt wi, Tilt wo, float alpha) { return ggxG1(wi, alpha) * ggxG1(wo, alpha); }

// Height-correlated, for reflection only: 1 / (1 + Lambda_i + Lambda_o).
float ggxG2Correlated(Tilt wi, Tilt wo, float alpha) {
  float sum = ggxRoot(wi, alpha) * wo.z + ggxRoot(wo, alpha) * wi.z;
  return sum > 0.0 ? 2.0 * wi.z * wo.z / sum : 0.0;
}

// G2 / (4 |wi.n| |wo.n|), the cosines divided out on paper: finite at the horizon, no epsilon. Below 1e-37 the quotient
// would leave float32's range (both directions within 1e-18 of the horizon and alpha = 0): the answer is 0, as at the
// horizon.
float ggxV(Tilt wi, Tilt wo, float alpha) {
  float sum = (wi.z + ggxRoot(wi, alpha)) * (wo.z + ggxRoot(wo, alpha));
  return sum > 1e-37 ? 1.0 / sum : 0.0;
}

float ggxVCorrelated(Tilt wi, Tilt wo, float alpha) {
  float sum = ggxRoot(wi, alpha) * wo.z + ggxRoot(wo, alpha) * wi.z;
  return sum > 1e-37 ? 0.5 / sum : 0.0;
}

// Density of wm drawn by ggxSample: D |wm . n|.
float ggxPdf(Tilt m, float alpha) { return ggxD(m, alpha) * tiltCos(m); }

// Density of wm drawn by ggxSampleVisible for this wo: G1(wo) D |wo . wm| / |wo . n|.
float ggxPdfVisible(Facet f, float alpha) {
  if (!f.exists) return 0.0;
  return 2.0 * f.woDotM * ggxD(f.h, alpha) / (f.wo.z + ggxRoot(f.wo, alpha));
}

// A normal with density D |wm . n|: tan² = alpha² u / (1 - u).
vec3 ggxSample(float alpha, vec2 u) {
  float phi = 2.0 * BSDF_PI * u.y;
  float across = alpha * sqrt(u.x);
  return normalize(vec3(across * cos(phi), across * sin(phi), sqrt(max(1.0 - u.x, 0.0))));
}

// A normal with the density that wo sees it at. Stretched by alpha (one width per axis), the surface is a hemisphere of
// mirrors: the ones that wo sees reflect it uniformly into a spherical cap. wo below the horizon is answered too, with
// the upper sides that it sees: walks between facets need them.
vec3 ggxSampleVisible(vec3 wo, vec2 alpha, vec2 u) {
  vec3 seen = normalize(vec3(alpha.x * wo.x, alpha.y * wo.y, wo.z));
  float phi = 2.0 * BSDF_PI * u.x;
  float z = (1.0 - u.y) * (1.0 + seen.z) - seen.z;
  float r = sqrt(clamp((1.0 - z) * (1.0 + z), 0.0, 1.0));
  vec3 h = vec3(r * cos(phi), r * sin(phi), z) + seen;
  // h is zero only where the cap's edge is drawn exactly from the horizon: probability 0, answered with the normal.
  vec3 m = vec3(alpha.x * h.x, alpha.y * h.y, max(h.z, 0.0));
  float s = dot(m, m);
  return s > 0.0 ? m * inversesqrt(s) : vec3(0.0, 0.0, 1.0);
}

#endif
