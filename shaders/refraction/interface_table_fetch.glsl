// interface_table_fetch.glsl: reads the tables of one rough interface.
// Frame    see interface_table.glsl; cosTheta = dot(wo, n) on the near side. Samplers linear, clamped to the edge.
// alpha    slope width in [0, 1] (clamped). eta = n_far / n_near.
// Returns  fetchInterfaceEnergy, fetchInterfaceTap: see interface_table.glsl; `tap` counts from 0 to `taps` - 1, `taps` is
//          the number that the texture was made for.
// Source   interface_table.glsl.
// Limits   those of interface_table.glsl.
#ifndef GG_REFRACTION_INTERFACE_TABLE_FETCH_GLSL
#define GG_REFRACTION_INTERFACE_TABLE_FETCH_GLSL

#include "refraction/interface_table.glsl"

InterfaceEnergy fetchInterfaceEnergy(sampler3D energyTable, float cosTheta, float alpha, float eta) {
  return interfaceEnergy(textureLod(energyTable, interfaceEnergyCoordinate(cosTheta, alpha, eta), 0.0));
}

InterfaceTap fetchInterfaceTap(sampler3D lobeTable, int tap, int taps, float cosTheta, float alpha, float eta) {
  vec4 texel = textureLod(lobeTable, interfaceLobeCoordinate(tap, taps, cosTheta, alpha, eta), 0.0);
  return interfaceTap(texel, cosTheta, alpha, eta);
}

#endif
