// diffuse.glsl: glTF's diffuse lobe under a dielectric coat.
// Frame    none; woDotM = |wo . wm| of the reflection half-vector, in [0, 1].
// alpha    none. albedo in [0, 1] per channel; fresnel: the coat's reflectance at woDotM, exact or Schlick's.
// Returns  diffuseF: (1 - F) albedo / pi in 1/sr, without the cosine; diffuseFCos: times cosI = |wi . n|.
// Source   [glTF20] appendix B.2.2 and B.3.
// Limits   the coat only takes its reflected share away; light reflected back inside the coat is not modelled.
#ifndef GG_BSDF_DIFFUSE_GLSL
#define GG_BSDF_DIFFUSE_GLSL

#include "bsdf/constants.glsl"

vec3 diffuseF(vec3 albedo, float fresnel) { return albedo * ((1.0 - fresnel) / BSDF_PI); }

vec3 diffuseFCos(vec3 albedo, float fresnel, float cosI) { return diffuseF(albedo, fresnel) * cosI; }

#endif
