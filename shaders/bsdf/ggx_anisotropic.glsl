// ggx_anisotropic.glsl: GGX with two widths, for brushed and stretched surfaces.
// Frame    local, n = +z, x along alpha.x; h the half-vector, any length; w any direction.
// alpha    slope widths along x and y, each > 0; 0 or less along either makes D and its pdf 0.
// Returns  ggxAnisoD: 1/sr. ggxAnisoLambda: >= 0. ggxAnisoG1, ggxAnisoG2...: [0, 1]. ggxAnisoV...: G2 / (4 |wi.n|
//          |wo.n|). ggxAnisoPdf...: 1/sr. ggxAnisoSample: unit wm. Visible normals: ggxSampleVisible of ggx.glsl,
//          which takes both widths.
//          ggxAnisoWidths: the two widths, .x >= .y > 0.
// Source   [Heitz14] eq. 85-87 (D and Lambda by stretching). KHR_materials_anisotropy (widths).
// Limits   as ggx.glsl. With equal widths every function equals its counterpart there (a test holds that).
#ifndef GG_BSDF_GGX_ANISOTROPIC_GLSL
#define GG_BSDF_GGX_ANISOTROPIC_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/ggx.glsl"

// glTF's: along the brushing mix(alpha, 1, strength²), across it alpha. A surface that is smooth across has no density: a line;
// a milliradian stands for it.
vec2 ggxAnisoWidths(float alpha, float strength) {
  float across = max(alpha, 1e-3);
  return vec2(across + (1.0 - across) * strength * strength, across);
}

// D = s² / (pi ax ay ((h.x / ax)² + (h.y / ay)² + h.z²)²) with s = |h|².
float ggxAnisoD(vec3 h, vec2 alpha) {
  float area = alpha.x * alpha.y;
  if (!(alpha.x > 0.0 && alpha.y > 0.0)) return 0.0;
  // All lengths times sqrt(area), which leaves ggx.glsl's alpha s / (p + alpha² z²) for equal widths.
  float p = h.x * h.x * (alpha.y / alpha.x) + h.y * h.y * (alpha.x / alpha.y);
  float spread = p + area * h.z * h.z;
  if (!(spread > 0.0)) return 0.0;
  float t = sqrt(area) * dot(h, h) / spread;
  return t * t / BSDF_PI;
}

// sqrt(z² + (ax x)² + (ay y)²) = (1 + 2 Lambda) |z|.
float ggxAnisoRoot(vec3 w, vec2 alpha) {
  return length(vec3(alpha.x * w.x, alpha.y * w.y, w.z));
}

float ggxAnisoLambda(vec3 w, vec2 alpha) {
  float z = abs(w.z);
  float x = alpha.x * w.x;
  float y = alpha.y * w.y;
  float slope = x * x + y * y;
  float below = 2.0 * z * (z + ggxAnisoRoot(w, alpha));
  return slope < 1e30 * below ? slope / below : 1e30;
}

float ggxAnisoG1(vec3 w, vec2 alpha) {
  float sum = abs(w.z) + ggxAnisoRoot(w, alpha);
  return sum > 0.0 ? 2.0 * abs(w.z) / sum : 0.0;
}

float ggxAnisoG2(vec3 wi, vec3 wo, vec2 alpha) {
  return ggxAnisoG1(wi, alpha) * ggxAnisoG1(wo, alpha);
}

float ggxAnisoV(vec3 wi, vec3 wo, vec2 alpha) {
  float sum = (abs(wi.z) + ggxAnisoRoot(wi, alpha)) * (abs(wo.z) + ggxAnisoRoot(wo, alpha));
  return sum > 0.0 ? 1.0 / sum : 0.0;
}

float ggxAnisoVCorrelated(vec3 wi, vec3 wo, vec2 alpha) {
  float sum = ggxAnisoRoot(wi, alpha) * abs(wo.z) + ggxAnisoRoot(wo, alpha) * abs(wi.z);
  return sum > 0.0 ? 0.5 / sum : 0.0;
}

// Density of wm drawn by ggxAnisoSample: D |wm . n|; h of any length.
float ggxAnisoPdf(vec3 h, vec2 alpha) { return ggxAnisoD(h, alpha) * tiltCos(tilt(h)); }

// Density of wm drawn by ggxSampleVisible(wo, alpha, u), for a facet (half_vector.glsl) of this wo and this h.
float ggxAnisoPdfVisible(Facet f, vec3 h, vec3 wo, vec2 alpha) {
  if (!f.exists) return 0.0;
  return 2.0 * f.woDotM * ggxAnisoD(h, alpha) / (abs(wo.z) + ggxAnisoRoot(wo, alpha));
}

vec3 ggxAnisoSample(vec2 alpha, vec2 u) {
  float phi = 2.0 * BSDF_PI * u.y;
  float across = sqrt(u.x);
  return normalize(vec3(alpha.x * across * cos(phi), alpha.y * across * sin(phi), sqrt(max(1.0 - u.x, 0.0))));
}

#endif
