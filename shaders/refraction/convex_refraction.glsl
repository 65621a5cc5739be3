// convex_refraction.glsl: rough refraction of a convex body whose thickness is known, without a pass for its back faces: the first
// tier. What a caller of KHR_materials_volume's usual one-interface refraction has at hand is enough.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face and of the back face (ConvexBody), [0, 1].
// Returns  refractConvex: linear radiance through both faces, first-order path and what is reflected inside, >= 0; without the
//          front face's own reflection (glass_reflection.glsl) and without tint: multiply by the base colour. enterGlass,
//          refractThrough: its two halves, for exits that are found in another way.
// Source   interface_table.glsl, composition.glsl; the engine's functions are those of engine.glsl.
// Limits   single scattering; a body that is not convex_body.glsl's lens is taken for one.
//          10 reads of tables, up to 21 of depth, 2 of the scene's colour, up to 3 of the environment.
#ifndef GG_REFRACTION_CONVEX_REFRACTION_GLSL
#define GG_REFRACTION_CONVEX_REFRACTION_GLSL

#include "bsdf/transmission.glsl"
#include "refraction/convex_body.glsl"
#include "refraction/face_lobes.glsl"
#include "refraction/glass_reflection.glsl"
#include "refraction/internal_scattering.glsl"

// What the exit reflects inside leaves a convex body by its near face, again and again: a geometric series. Nothing leaves a face
// wider than a diffuse one sends light, 0.606 radians per axis. It comes from where the camera does not look: a part of the
// environment there is occluded, not known which. Of 0, 1/4, 1/2, 3/4 and 1 a quarter was nearest to the truth, or nearly so, on
// most scenes tried; slabs before a wall, whose light comes from behind the camera, would have all of it.
const float SCATTERED_SEEN = 0.25;
// Less than this share of the environment is not looked up: what it would add is below the error of SCATTERED_SEEN.
const float SCATTERED_LEAST = 0.01;

vec3 internallyReflected(GlassFace face, ConvexBody body, InnerLobe inner, float entered, ConvexExit e, float passed) {
  float cosTheta = max(dot(inner.direction, e.surface.n), 0.0);
  InterfaceEnergy own = engineFaceEnergy(cosTheta, body.backAlpha, e.surface.eta);
  InternalScattering w;
  w.passes = passed;
  w.back = clamp(own.transmitted + own.reflected - passed, 0.0, 0.99);
  vec3 way = exp(-e.path * body.attenuation);
  vec3 weight = SCATTERED_SEEN * entered * w.back * way * internalScatteringEscapes(w, way);
  if (max(weight.x, max(weight.y, weight.z)) < SCATTERED_LEAST) return vec3(0.0);
  vec3 reflected = inner.direction - 2.0 * cosTheta * e.surface.n;
  float q = clamp(body.thickness * body.curvature, 0.0, 2.0);
  vec3 near = normalize(mix(face.n, e.surface.n + 2.0 * cosTheta * reflected, 0.5 * q));
  vec3 outward = refractAbout(-reflected, -near, e.surface.eta);
  float spread = sqrt(inner.sigma * inner.sigma + 4.0 * body.backAlpha * body.backAlpha) * body.ior;
  vec3 direction = dot(outward, outward) > 0.0 ? outward : near;
  return weight * engineEnvironment(direction, min(spread, 0.606));
}

// What the near face makes of the view: core and tail of its lobe inside.
struct Entering {
  InnerLobe core;
  InnerLobe tail;
  float energy;
};

Entering enterGlass(GlassFace face, float ior) {
  Entering e;
  float cosTheta = dot(face.wo, face.n);
  e.energy = engineFaceEnergy(cosTheta, face.alpha, ior).transmitted;
  FaceLobes lobes = engineFaceLobes(cosTheta, face.alpha, ior);
  e.core = engineEnteringLobe(lobes.core, face, ior, e.energy);
  e.tail = engineEnteringLobe(lobes.tail, face, ior, e.energy);
  return e;
}

// What core and tail become outside.
struct Leaving {
  ComposedPair pair;
  float passed; // share of the core that the exit let through
};

Leaving leaveGlass(GlassFace face, ConvexBody body, Entering e, ConvexExit coreExit, ConvexExit tailExit, Widening k) {
  Leaving leaving;
  leaving.pair = engineLeavingPair(e.core, true, coreExit.surface, k);
  leaving.passed = e.core.weight > 0.0 ? (leaving.pair.core.weight + leaving.pair.rest.weight) / e.core.weight : 0.0;
  if (e.tail.weight > 0.0) leaving.pair = mergePairs(leaving.pair, engineLeavingPair(e.tail, false, tailExit.surface, k));
  // Over the pixel both faces turn together, as a prism's do: by 2 (1 - 1 / ior) of the normal's turn.
  float bent = 2.0 * (1.0 - 1.0 / body.ior);
  leaving.pair.core.sigma = sqrt(leaving.pair.core.sigma * leaving.pair.core.sigma + bent * bent * face.turn);
  return leaving;
}

// What a pair of lobes shows that leaves at `origin`, `inside` metres after the near face.
vec3 pairRadiance(ComposedPair pair, vec3 origin, float inside, SceneView view) {
  // The rest leaves beside the core and meets the same thing.
  SceneIntersection met = sceneIntersection(origin, pair.core.direction, view);
  vec3 sum = vec3(0.0);
  ComposedLobe lobe = pair.core;
  for (int which = 0; which < 2 && (which == 0 || lobe.weight > 0.0); ++which) {
    sum += lobe.weight * lobeRadiance(lobe, origin, inside, met, view);
    lobe = pair.rest;
  }
  return sum;
}

// On through the exits that core and tail meet, the core's at `origin`, to what is seen there.
vec3 refractThrough(GlassFace face, ConvexBody body, Entering e, vec3 origin, ConvexExit coreExit, ConvexExit tailExit,
                    SceneView view, Widening k) {
  Leaving left = leaveGlass(face, body, e, coreExit, tailExit, k);
  vec3 sum = pairRadiance(left.pair, origin, coreExit.path, view);
  return sum * exp(-coreExit.path * body.attenuation) + internallyReflected(face, body, e.core, e.energy, coreExit, left.passed);
}

vec3 refractConvex(GlassFace face, ConvexBody body, SceneView view, Widening k) {
  Entering e = enterGlass(face, body.ior);
  ConvexExit core = convexExit(face.n, e.core.direction, body);
  vec3 origin = face.position + core.path * e.core.direction;
  return refractThrough(face, body, e, origin, core, convexExit(face.n, e.tail.direction, body), view, k);
}

#endif
