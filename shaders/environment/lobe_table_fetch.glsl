// lobe_table_fetch.glsl: reads the tables of the reflection lobe.
// Frame    world: n, wo unit; samplers linear, clamped to the edge.
// alpha    slope width in [0, 1] (clamped).
// Returns  fetchLobeEnergy, fetchReflectionLobe (of one), fetchReflectionLobeOf (of several): see lobe_table.glsl.
//          fetchStandardLobe: the usual approximation: the mirror direction at the width of the lobe at normal incidence.
// Source   lobe_table.glsl.
// Limits   those of lobe_table.glsl.
#ifndef GG_ENVIRONMENT_LOBE_TABLE_FETCH_GLSL
#define GG_ENVIRONMENT_LOBE_TABLE_FETCH_GLSL

#include "environment/lobe_table.glsl"

LobeEnergy fetchLobeEnergy(sampler2D energyTable, float cosTheta, float alpha) {
  return lobeEnergy(textureLod(energyTable, energyCoordinate(cosTheta, alpha), 0.0));
}

// edge: edgeShare() of the surface's reflectance. `lobes` is the number that the texture was made for, `lobe` counts from 0.
ReflectionLobe fetchReflectionLobeOf(sampler3D lobeTable, int lobe, int lobes, vec3 wo, vec3 n, float alpha, float edge) {
  float cosTheta = dot(wo, n);
  vec4 texel = textureLod(lobeTable, lobeCoordinateOf(lobe, lobes, cosTheta, alpha, edge), 0.0);
  ReflectionLobe found;
  found.direction = lobeDirection(2.0 * cosTheta * n - wo, n, texel.x);
  found.sigma = texel.y * alpha;
  found.weight = texel.z;
  return found;
}

ReflectionLobe fetchReflectionLobe(sampler3D lobeTable, vec3 wo, vec3 n, float alpha, float edge) {
  return fetchReflectionLobeOf(lobeTable, 0, 1, wo, n, alpha, edge);
}

// From a texture of one lobe.
ReflectionLobe fetchStandardLobe(sampler3D lobeTable, vec3 wo, vec3 n, float alpha) {
  ReflectionLobe lobe;
  lobe.direction = 2.0 * dot(wo, n) * n - wo;
  lobe.sigma = textureLod(lobeTable, lobeCoordinate(1.0, alpha, 0.0), 0.0).y * alpha;
  lobe.weight = 1.0;
  return lobe;
}

#endif
