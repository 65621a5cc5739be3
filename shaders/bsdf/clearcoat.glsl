// clearcoat.glsl: a thin clear layer over any surface: what it reflects the surface under it does not see.
// Frame    none: cosTheta = |wo . n| of the coat's own normal.
// alpha    none: the coat's lobe is D V of its own width (ggx.glsl).
// Returns  coatShare: [0, 1]. Of what is seen along wo the share that the coat's lobe makes; the base, with what it emits, makes
//          1 - coatShare, which coatPasses gives with all its digits towards the horizon. Both at the angle to the normal, so
//          that energy is kept whatever the lobes lose.
// Source   KHR_materials_clearcoat, "Layering": mix(base, coat, clearcoat F(|N . V|)), ior 1.5. F is exact, not Schlick's.
// Limits   not reciprocal, as the extension is not: light on its way in is not weakened. The coat absorbs nothing, bends nothing.
#ifndef GG_BSDF_CLEARCOAT_GLSL
#define GG_BSDF_CLEARCOAT_GLSL

#include "bsdf/fresnel_dielectric.glsl"

const float COAT_IOR = 1.5;

// strength: [0, 1].
float coatShare(float strength, float cosTheta) { return strength * fresnelDielectricAt(cosTheta, COAT_IOR); }

float coatPasses(float strength, float cosTheta) {
  return (1.0 - strength) + strength * fresnelTransmittedAt(cosTheta, COAT_IOR);
}

#endif
