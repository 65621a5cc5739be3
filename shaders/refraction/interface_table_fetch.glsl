// interface_table_fetch.glsl: reads the tables of one rough interface.
// Frame    see interface_table.glsl; cosTheta = dot(wo, n) on the near side. Samplers linear, clamped to the edge.
// alpha    slope width in [0, 1] (clamped). eta = n_far / n_near.
// Returns  fetchInterfaceEnergy, fetchInterfaceLobe: see interface_table.glsl; `lobe` counts from 0 to `lobes` - 1, `lobes` is
//          the number that the texture was made for.
// Source   interface_table.glsl.
// Limits   those of interface_table.glsl.
#ifndef GG_REFRACTION_INTERFACE_TABLE_FETCH_GLSL
#define GG_REFRACTION_INTERFACE_TABLE_FETCH_GLSL

#include "refraction/interface_table.glsl"

InterfaceEnergy fetchInterfaceEnergy(sampler3D energyTable, float cosTheta, float alpha, float eta) {
  return interfaceEnergy(textureLod(energyTable, interfaceEnergyCoordinate(cosTheta, alpha, eta), 0.0));
}

InterfaceLobe fetchInterfaceLobe(sampler3D lobeTable, int lobe, int lobes, float cosTheta, float alpha, float eta) {
  vec4 texel = textureLod(lobeTable, interfaceLobeCoordinate(lobe, lobes, cosTheta, alpha, eta), 0.0);
  return interfaceLobe(texel, cosTheta, alpha, eta);
}

#endif
