// glass_reflection.glsl: what the near face of rough glass reflects of the scene and the environment.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the face, [0, 1]. ior = n_inside / n_outside > 0.
// Returns  reflectGlass: linear radiance, >= 0. engineFaceEnergy: shares of the light at one face, [0, 1].
// Source   lobe_table.glsl: the lobe as one Gaussian; interface_table.glsl: its energy.
// Limits   single scattering. Of the scene what the camera sees is reflected. 2 reads of tables, up to 21 of
//          depth, 1 of the scene's colour and 1 of the environment.
#ifndef GG_REFRACTION_GLASS_REFLECTION_GLSL
#define GG_REFRACTION_GLASS_REFLECTION_GLSL

#include "environment/lobe_table.glsl"
#include "refraction/interface_table.glsl"
#include "refraction/scene_lookup.glsl"

struct GlassFace {
  vec3 position;
  vec3 n;
  vec3 wo;
  float alpha;
  float turn; // radians² per axis: variance of n over the pixel, which every lobe is at least as wide as
};

// A lobe narrower than this is one direction for a picture: a pixel is wider. Faces are then smooth, and no table is read.
const float SMOOTH_ALPHA = 1e-3;

InterfaceEnergy engineFaceEnergy(float cosTheta, float alpha, float eta) {
  if (alpha < SMOOTH_ALPHA) {
    InterfaceEnergy smoothly;
    smoothly.transmitted = fresnelTransmittedAt(cosTheta, eta);
    smoothly.reflected = 1.0 - smoothly.transmitted;
    return smoothly;
  }
  return interfaceEnergy(engineInterfaceEnergy(interfaceEnergyCoordinate(cosTheta, alpha, eta)));
}

vec3 reflectGlass(GlassFace face, float ior, SceneView view) {
  float cosTheta = dot(face.wo, face.n);
  float energy = engineFaceEnergy(cosTheta, face.alpha, ior).reflected;
  vec4 texel = vec4(0.0);
  if (face.alpha >= SMOOTH_ALPHA)
    texel = engineReflectionLobe(lobeCoordinate(cosTheta, face.alpha, edgeShare(fresnelNormalIncidence(ior), energy)));
  ComposedLobe lobe;
  lobe.direction = lobeDirection(2.0 * cosTheta * face.n - face.wo, face.n, texel.x);
  lobe.sigma = sqrt(texel.y * texel.y * face.alpha * face.alpha + 4.0 * face.turn); // a mirror turns by twice its normal's turn
  lobe.weight = energy;
  lobe.inner = 0.0;
  lobe.carried = 0.0;
  SceneIntersection met = sceneIntersection(face.position, lobe.direction, view);
  return energy * lobeRadiance(lobe, face.position, 0.0, met, view);
}

#endif
