// lobe_table.glsl: where the tables of the reflection lobe are read, and what is made of what they hold.
// Frame    any: n, wo, r unit; r the mirror image of wo.
// alpha    slope width in [0, 1] (clamped).
// Returns  energyCoordinate, lobeCoordinate (one lobe), lobeCoordinateOf (of `lobes`): texture coordinates in [0, 1].
//          lobeAlbedo...: the fraction of light reflected, hemispherical-directional, single scattering, in [0, 1].
//          edgeShare: how much of it comes from Schlick's edge, in [0, 1]. lobeDirection: unit. diffuseFresnel..: mean of F
//          over the facets that join wo to a diffuse hemisphere.
// Source   made by `groundglass tables` (app/tables) from the exact integrals.
// Limits   two effective angles stand for the distribution of wo . wm: albedos are within 0.003 of the exact integral for
//          dielectrics from 1.1 to 2.5, for Schlick's form and for metals (aluminium is the worst, others 0.002).
#ifndef GG_ENVIRONMENT_LOBE_TABLE_GLSL
#define GG_ENVIRONMENT_LOBE_TABLE_GLSL

#include "environment/table_axis.glsl"

const int ENERGY_TABLE_SIZE = 64; // texels along both axes
const int LOBE_TABLE_SIZE = 32;   // texels along cos and alpha
const int LOBE_TABLE_SLICES = 5;  // along the edge's share

// The lobe's energy as two mirrors: albedo (cosShare F(cos1) + (1 - cosShare) F(cos2)) for any reflectance F.
struct LobeEnergy {
  float albedo; // for F = 1
  float cos1;
  float cos2;
  float share1;
};

// One lookup in a Gaussian stack.
struct ReflectionLobe {
  vec3 direction;
  float sigma;  // radians
  float weight; // of K lobes they sum to 1; lobe 0 is the core, the narrowest
};

// Square roots: grazing angles and small widths need the detail.
vec2 energyCoordinate(float cosTheta, float alpha) {
  return vec2(tableCoordinate(sqrt(max(cosTheta, 0.0)), ENERGY_TABLE_SIZE),
              tableCoordinate(sqrt(max(alpha, 0.0)), ENERGY_TABLE_SIZE));
}

vec3 lobeCoordinateOf(int lobe, int lobes, float cosTheta, float alpha, float edge) {
  return vec3(tableCoordinate(sqrt(max(cosTheta, 0.0)), LOBE_TABLE_SIZE),
              blockCoordinate(sqrt(max(alpha, 0.0)), LOBE_TABLE_SIZE, lobe, lobes),
              tableCoordinate(edge, LOBE_TABLE_SLICES));
}

vec3 lobeCoordinate(float cosTheta, float alpha, float edge) {
  return lobeCoordinateOf(0, 1, cosTheta, alpha, edge);
}

LobeEnergy lobeEnergy(vec4 texel) {
  LobeEnergy e;
  e.albedo = texel.x;
  e.cos1 = texel.y;
  e.cos2 = texel.z;
  e.share1 = texel.w;
  return e;
}

// F at both effective angles -> its mean over the lobe, which times e.albedo is the albedo.
float lobeMean(LobeEnergy e, float fAtCos1, float fAtCos2) { return mix(fAtCos2, fAtCos1, e.share1); }
vec3 lobeMeanRgb(LobeEnergy e, vec3 fAtCos1, vec3 fAtCos2) { return mix(fAtCos2, fAtCos1, e.share1); }

// Of a mean reflectance, what exceeds the reflectance f0 at normal incidence. 0 where the edge takes light away.
float edgeShare(float f0, float mean) { return mean > 0.0 ? clamp(1.0 - f0 / mean, 0.0, 1.0) : 0.0; }

// From the mirror direction (lean 0) towards the normal (lean 1), or beyond either.
vec3 lobeDirection(vec3 r, vec3 n, float lean) { return normalize(mix(r, n, lean)); }

// Two effective angles for the diffuse term, whose facets join wo to every wi with weight wi.n / pi (no width enters):
// the mean of F(wo . wm) is share F(x) + (1 - share) F(y), within 0.0002 for dielectrics from 1.1 to 2.5 and Schlick.
vec3 diffuseAngles(float cosTheta) {
  float c = clamp(cosTheta, 0.0, 1.0);
  return vec3(0.2791 * c + 0.2660, 0.1798 * c + 0.6974, 0.1224 * (1.0 - c));
}

#endif
