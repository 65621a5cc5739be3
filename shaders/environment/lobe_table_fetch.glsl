// lobe_table_fetch.glsl: reads the tables of the reflection lobe.
// Frame    world: n, wo unit; samplers linear, clamped to the edge.
// alpha    slope width in [0, 1] (clamped).
// Returns  fetchLobeEnergy, fetchLobeTap (of one), fetchLobeTapOf (of several): see lobe_table.glsl. fetchStandardTap: what
//          peers do, the mirror direction at the width of the lobe at normal incidence.
// Source   lobe_table.glsl.
// Limits   those of lobe_table.glsl.
#ifndef GG_ENVIRONMENT_LOBE_TABLE_FETCH_GLSL
#define GG_ENVIRONMENT_LOBE_TABLE_FETCH_GLSL

#include "environment/lobe_table.glsl"

LobeEnergy fetchLobeEnergy(sampler2D energyTable, float cosTheta, float alpha) {
  return lobeEnergy(textureLod(energyTable, energyCoordinate(cosTheta, alpha), 0.0));
}

// edge: edgeShare() of the surface's reflectance. `taps` is the number that the texture was made for, `tap` counts from 0.
LobeTap fetchLobeTapOf(sampler3D lobeTable, int tap, int taps, vec3 wo, vec3 n, float alpha, float edge) {
  float cosTheta = dot(wo, n);
  vec4 texel = textureLod(lobeTable, lobeCoordinateOf(tap, taps, cosTheta, alpha, edge), 0.0);
  LobeTap found;
  found.direction = lobeDirection(2.0 * cosTheta * n - wo, n, texel.x);
  found.sigma = texel.y * alpha;
  found.weight = texel.z;
  return found;
}

LobeTap fetchLobeTap(sampler3D lobeTable, vec3 wo, vec3 n, float alpha, float edge) {
  return fetchLobeTapOf(lobeTable, 0, 1, wo, n, alpha, edge);
}

// From a texture of one tap.
LobeTap fetchStandardTap(sampler3D lobeTable, vec3 wo, vec3 n, float alpha) {
  LobeTap tap;
  tap.direction = 2.0 * dot(wo, n) * n - wo;
  tap.sigma = textureLod(lobeTable, lobeCoordinate(1.0, alpha, 0.0), 0.0).y * alpha;
  tap.weight = 1.0;
  return tap;
}

#endif
