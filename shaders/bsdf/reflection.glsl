// reflection.glsl: the rough reflection lobe f_r, ideal reflection, and the densities of reflected directions.
// Frame    any: wi, wo unit and away from the surface, n through Facet (half_vector.glsl).
// alpha    through d and v: D at facet.h and V at (facet.wi, facet.wo), of any one distribution.
// Returns  reflectionF: f_r in 1/sr, without the cosine; reflectionFCos: f_r |wi . n|; the ...Lobe form leaves F out,
//          for metals in colour (multiply by fresnelConductorRgb). reflectionPdf: 1/sr. All 0 where no facet exists.
// Source   [Walter07] eq. 20 (f_r), 14 (Jacobian), 39 (ideal reflection).
// Limits   single scattering. A smooth surface (alpha = 0) is a delta: its finite part, 0, is what these return, and
//          the whole of it is reflectAbout(wo, n) weighted by F. Index 1 reflects nothing: F = 0.
#ifndef GG_BSDF_REFLECTION_GLSL
#define GG_BSDF_REFLECTION_GLSL

#include "bsdf/fresnel_dielectric.glsl"
#include "bsdf/half_vector.glsl"

// D V = D G / (4 |wi.n| |wo.n|): f_r of a surface that reflects everything. Where D is 0, V may be infinite (alpha =
// 0 and both directions within 1e-19 of the horizon).
float reflectionLobe(Facet f, float d, float v) { return f.exists && d > 0.0 ? d * v : 0.0; }

float reflectionF(Facet f, float d, float v, float eta) {
  return reflectionLobe(f, d, v * fresnelDielectric(f.woDotM, f.g, eta)); // F = 0 before D V overflows
}

float reflectionFCos(Facet f, float d, float v, float eta) {
  return reflectionF(f, d, v, eta) * f.wi.z;
}

// Density of wi for a known wo, when wm has density pdfM.
float reflectionPdf(Facet f, float pdfM) { return pdfM * reflectionJacobian(f); }

// Mirror image of wo about the facet wm, unit.
vec3 reflectAbout(vec3 wo, vec3 wm) { return 2.0 * dot(wo, wm) * wm - wo; }

#endif
