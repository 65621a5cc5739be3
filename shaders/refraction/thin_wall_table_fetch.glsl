// thin_wall_table_fetch.glsl: reads the tables of a thin wall.
// Frame    see thin_wall_table.glsl; cosTheta = dot(wo, n). Samplers linear, clamped to the edge.
// alpha    slope width of both faces in [0, 1] (clamped). eta: the wall's index over its surroundings'.
// Returns  fetchThinWallEnergy, fetchThinWallLobe: see thin_wall_table.glsl; `lobe` counts from 0 to `lobes` - 1, `lobes` (1 or
//          2) is the number that the texture was made for.
// Source   thin_wall_table.glsl.
// Limits   those of thin_wall_table.glsl.
#ifndef GG_REFRACTION_THIN_WALL_TABLE_FETCH_GLSL
#define GG_REFRACTION_THIN_WALL_TABLE_FETCH_GLSL

#include "refraction/thin_wall_table.glsl"

ThinWallEnergy fetchThinWallEnergy(sampler3D energyTable, float cosTheta, float alpha, float eta) {
  return thinWallEnergy(textureLod(energyTable, thinWallCoordinate(0, 1, cosTheta, alpha, eta), 0.0));
}

InterfaceLobe fetchThinWallLobe(sampler3D lobeTable, int lobe, int lobes, float cosTheta, float alpha, float eta) {
  vec4 texel = textureLod(lobeTable, thinWallCoordinate(lobe, lobes, cosTheta, alpha, eta), 0.0);
  return thinWallLobe(texel, cosTheta, alpha, eta);
}

#endif
