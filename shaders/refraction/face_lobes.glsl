// face_lobes.glsl: the lobes of one face of glass as an engine's tables give them, for light that enters and that leaves.
// Frame    world; n on the side of wo, directions unit.
// alpha    of the face, [0, 1]; below SMOOTH_ALPHA it has one direction, Snell's, and no table is read.
// Returns  engineFaceLobes: core and tail of one interface. engineEnteringLobe: one of them inside, its weight times the energy
//          that enters. engineLeavingPair: what an inner lobe becomes outside, one or two lobes.
// Source   interface_table.glsl, composition.glsl; the engine's functions are those of engine.glsl.
// Limits   those of composition.glsl. Reads of tables: 2, 0 and 3.
#ifndef GG_REFRACTION_FACE_LOBES_GLSL
#define GG_REFRACTION_FACE_LOBES_GLSL

#include "refraction/composition.glsl"
#include "refraction/glass_reflection.glsl"

// Both of the tables' lobes, which differ in the block of the table that they are read from. A smooth face has one: Snell's.
struct FaceLobes {
  InterfaceLobe core;
  InterfaceLobe tail;
};

FaceLobes engineFaceLobes(float cosTheta, float alpha, float eta) {
  vec4 core = vec4(0.0, 0.0, 1.0, 0.0);
  vec4 tail = vec4(0.0);
  if (alpha >= SMOOTH_ALPHA) {
    vec3 at = interfaceLobeCoordinate(0, 2, cosTheta, alpha, eta);
    core = engineInterfaceLobe(at);
    tail = engineInterfaceLobe(at + vec3(0.0, 0.5, 0.0));
  }
  FaceLobes lobes;
  lobes.core = interfaceLobe(core, cosTheta, alpha, eta);
  lobes.tail = interfaceLobe(tail, cosTheta, alpha, eta);
  return lobes;
}

InnerLobe engineEnteringLobe(InterfaceLobe read, GlassFace face, float ior, float energy) {
  InnerLobe inner;
  bool matched = abs(ior - 1.0) < INDEX_MATCHED;
  inner.direction = matched ? -face.wo : interfaceLobeDirection(face.wo, face.n, read.angle);
  inner.sigma = matched ? 0.0 : read.sigma;
  inner.weight = read.weight * (matched ? 1.0 : energy);
  return inner;
}

ComposedPair engineLeavingPair(InnerLobe inner, bool core, ExitSurface s, Widening k) {
  ExitView view = seeExit(inner, core, s, k);
  float cosTheta = max(view.cosTheta, 0.0);
  float energy = abs(s.eta - 1.0) < INDEX_MATCHED ? 1.0 : engineFaceEnergy(cosTheta, view.alphaEnergy, s.eta).transmitted;
  FaceLobes lobes = engineFaceLobes(cosTheta, view.alphaShape, s.eta);
  if (view.alphaShape < SMOOTH_ALPHA) {
    ComposedPair one;
    one.core = composeLobe(inner, view, s, lobes.core.angle, lobes.core.sigma, 1.0, energy);
    one.rest = one.core;
    one.rest.weight = 0.0;
    return one;
  }
  return composedPair(composeLobe(inner, view, s, lobes.core.angle, lobes.core.sigma, lobes.core.weight, energy),
                      composeLobe(inner, view, s, lobes.tail.angle, lobes.tail.sigma, lobes.tail.weight, energy), view);
}

#endif
