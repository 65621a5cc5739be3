// two_pair_refraction.glsl: rough refraction through two pairs of faces, with total internal reflections: the third tier. Behind
// the first body stands the far wall of a hollow one, or another body.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face, [0, 1]; the other faces' is what their passes say.
// Returns  refractTwoPairs: as refractFrontBack. REFLECTIONS_INSIDE: total internal reflections that are followed in each body.
// Source   front_back_refraction.glsl twice; composition.glsl in both directions through a face.
// Limits   the second body has the index and the absorption of the first. Behind it no glass is seen. Its entry's two lobes go on
//          as one. In the second front face the environment is reflected. Up to 20 reads of tables, 100 of
//          faces, 21 of depth, 2 of the scene's colour and 4 of the environment.
#ifndef GG_REFRACTION_TWO_PAIR_REFRACTION_GLSL
#define GG_REFRACTION_TWO_PAIR_REFRACTION_GLSL

#include "refraction/front_back_refraction.glsl"

const int REFLECTIONS_INSIDE = 3;

// By the nearest back faces, or by those behind: a ray that runs along a wall comes out on the far side of a hollow body.
WayOut wayOutOfTwo(vec3 origin, InnerLobe lobe, float eta, float number, SceneView view) {
  WayOut near = wayOut(origin, lobe, eta, leavingFaces(BACK_FACES, number), REFLECTIONS_INSIDE, view);
  if (near.found) return near;
  return wayOut(origin, lobe, eta, leavingFaces(SECOND_BACKS, number), REFLECTIONS_INSIDE, view);
}

InnerLobe lobeOnward(ComposedLobe lobe) {
  InnerLobe onward;
  onward.direction = lobe.direction;
  onward.sigma = lobe.sigma;
  onward.weight = lobe.weight;
  return onward;
}

// What a pair of lobes shows that leaves the first body at `origin`.
vec3 secondBody(ComposedPair pair, vec3 origin, float inside, ConvexBody body, SceneView view, Widening k) {
  FaceLayer fronts = leavingFaces(SECOND_FRONTS, -1.0);
  fronts.side = -1.0;
  BackFaceExit front = backFaceExit(origin, pair.core.direction, 0.0, body.ior, fronts, view);
  if (!front.found) return pairRadiance(pair, origin, inside, view);
  InnerLobe outer = lobeOnward(pair.core);
  ComposedPair entered = engineLeavingPair(outer, true, front.exit.surface, k);
  InnerLobe inner = lobeOnward(mergeLobes(entered.core, entered.rest));
  vec3 point = origin + front.exit.path * outer.direction;
  WayOut way = wayOut(point, inner, 1.0 / body.ior, leavingFaces(SECOND_BACKS, front.number), REFLECTIONS_INSIDE, view);
  if (!way.found) return pairRadiance(pair, origin, inside, view);
  ComposedPair beyond = engineLeavingPair(way.lobe, true, way.exit.surface, k);
  // The spread on the way between the bodies is a spread of places where the second is left.
  float between = front.exit.path + way.exit.path / body.ior;
  beyond.core.inner = outer.sigma;
  beyond.rest.inner = outer.sigma;
  // The first body's rest goes beside its core through the same faces.
  float passed = outer.weight > 0.0 ? (beyond.core.weight + beyond.rest.weight) / outer.weight : 0.0;
  ComposedLobe aside = pair.rest;
  aside.direction = normalize(pair.rest.direction + beyond.core.direction - pair.core.direction);
  aside.weight *= passed;
  beyond.rest = mergeLobes(beyond.rest, aside);
  vec3 sum = exp(-way.exit.path * body.attenuation) * pairRadiance(beyond, way.point, between, view);
  // What the second front face reflects.
  float cosTheta = dot(outer.direction, front.exit.surface.n);
  float alpha = front.exit.surface.alpha;
  float weight = (pair.core.weight + pair.rest.weight) * engineFaceEnergy(cosTheta, alpha, body.ior).reflected;
  vec3 mirrored = outer.direction - 2.0 * cosTheta * front.exit.surface.n;
  return sum + weight * engineEnvironment(mirrored, min(sqrt(outer.sigma * outer.sigma + 4.0 * alpha * alpha), 0.606));
}

vec3 refractTwoPairs(GlassFace face, ConvexBody body, float number, SceneView view, Widening k) {
  Entering entered = enterGlass(face, body.ior);
  WayOut core = wayOutOfTwo(face.position, entered.core, 1.0 / body.ior, number, view);
  if (!core.found) return refractConvex(face, body, view, k);
  entered.core = core.lobe;
  WayOut tail = core;
  if (entered.tail.weight > 0.0) {
    tail = wayOutOfTwo(face.position, entered.tail, 1.0 / body.ior, number, view);
    if (tail.found) entered.tail = tail.lobe;
    if (!tail.found) tail.exit = core.exit;
  }
  Leaving left = leaveGlass(face, body, entered, core.exit, tail.exit, k);
  vec3 sum = secondBody(left.pair, core.point, core.exit.path, body, view, k);
  return sum * exp(-core.exit.path * body.attenuation)
         + internallyReflected(face, body, entered.core, entered.energy, core.exit, left.passed);
}

#endif
