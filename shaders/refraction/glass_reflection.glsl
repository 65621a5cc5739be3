// glass_reflection.glsl: what the near face of rough glass reflects of the scene and the environment.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the face, [0, 1]. ior = n_inside / n_outside > 0.
// Returns  reflectGlass: linear radiance, >= 0; through in [0, 1]. engineFaceEnergy: shares of the light at one face, [0, 1].
// Source   lobe_table.glsl: the lobe as one Gaussian; interface_table.glsl: its energy.
// Limits   single scattering. Of the scene what the camera sees is reflected. 2 reads of tables, 1 or 2 of the environment, and
//          where it is looked for up to 21 of depth and 1 of the scene's colour.
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

InterfaceEnergy engineFaceEnergy(float cosTheta, float alpha, float eta) {
  return interfaceEnergy(engineInterfaceEnergy(interfaceEnergyCoordinate(cosTheta, alpha, eta)));
}

// Where the mirror is less than 4 % of all that is seen, what clear glass reflects squarely, it is not looked for in the scene;
// from 8 % on in full. through: what gets through the glass, at its brightest channel.
float reflectionLooked(float reflected, float through) {
  return smoothstep(0.04, 0.08, reflected / max(reflected + through, 1e-6));
}

vec3 reflectGlass(GlassFace face, float ior, float through, SceneView view) {
  float cosTheta = dot(face.wo, face.n);
  float energy = engineFaceEnergy(cosTheta, face.alpha, ior).reflected;
  vec4 texel = engineReflectionLobe(lobeCoordinate(cosTheta, face.alpha, edgeShare(fresnelNormalIncidence(ior), energy)));
  ComposedTap tap;
  tap.direction = lobeDirection(2.0 * cosTheta * face.n - face.wo, face.n, texel.x);
  tap.sigma = sqrt(texel.y * texel.y * face.alpha * face.alpha + 4.0 * face.turn); // a mirror turns by twice its normal's turn
  tap.weight = energy;
  tap.inner = 0.0;
  tap.carried = 0.0;
  float looked = reflectionLooked(energy, through);
  vec3 far = looked < 1.0 ? engineEnvironment(tap.direction, tap.sigma) : vec3(0.0);
  if (looked == 0.0) return energy * far;
  SceneMeeting met = sceneMeeting(face.position, tap.direction, view);
  return energy * mix(far, lobeRadiance(tap, face.position, 0.0, met, view), looked);
}

#endif
