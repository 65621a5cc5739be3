// two_pair_refraction.glsl: rough refraction through two pairs of faces, with total internal reflections: the third tier. Behind
// the first body stands the far wall of a hollow one, or another body.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face, [0, 1]; the other faces' is what their passes say.
// Returns  refractTwoPairs: as refractFrontBack. REFLECTIONS_INSIDE: total internal reflections that are followed in each body.
// Source   front_back_refraction.glsl twice; composition.glsl in both directions through a face.
// Limits   the second body has the index and the absorption of the first. Behind it no glass is seen. Its entry's two lobes go on
//          as one. In the second front face the environment is reflected. Up to 20 reads of tables, 104 of
//          faces, 21 of depth, 2 of the scene's colour and 4 of the environment.
#ifndef GG_REFRACTION_TWO_PAIR_REFRACTION_GLSL
#define GG_REFRACTION_TWO_PAIR_REFRACTION_GLSL

#include "refraction/front_back_refraction.glsl"

const int REFLECTIONS_INSIDE = 3;

InnerLobe lobeOnward(ComposedLobe lobe) {
  InnerLobe onward;
  onward.direction = lobe.direction;
  onward.sigma = lobe.sigma;
  onward.weight = lobe.weight;
  return onward;
}

// What becomes of a pair of lobes that leaves the first body.
struct SecondBody {
  ComposedPair pair; // behind the second body, if it is met
  vec3 origin;       // where that is left
  float inside;      // metres from the first body's exit, those in glass divided by the index; of the first body without
  vec3 passed;       // absorption
  vec3 reflected;    // radiance that the second front face mirrors
};

SecondBody throughSecondBody(ComposedPair pair, vec3 origin, float inside, ConvexBody body, SceneView view, Widening k) {
  SecondBody second;
  second.pair = pair;
  second.origin = origin;
  second.inside = inside;
  second.passed = vec3(1.0);
  second.reflected = vec3(0.0);
  FaceLayer fronts = leavingFaces(SECOND_FRONTS, -1.0);
  fronts.side = -1.0;
  BackFaceExit front = backFaceExit(origin, pair.core.direction, 0.0, body.ior, fronts, view);
  if (!front.found) return second;
  InnerLobe outer = lobeOnward(pair.core);
  ComposedPair entered = engineLeavingPair(outer, true, front.exit.surface, k);
  InnerLobe inner = lobeOnward(mergeLobes(entered.core, entered.rest));
  vec3 point = origin + front.exit.path * outer.direction;
  WayOut way = wayOut(point, inner, 1.0 / body.ior, leavingFaces(SECOND_BACKS, front.number), REFLECTIONS_INSIDE, view);
  if (!way.found) return second;
  ComposedPair beyond = engineLeavingPair(way.lobe, true, way.exit.surface, k);
  // The spread on the way between the bodies is a spread of places where the second is left.
  second.inside = front.exit.path + way.exit.path / body.ior;
  beyond.core.inner = outer.sigma;
  beyond.rest.inner = outer.sigma;
  // The first body's rest goes beside its core through the same faces.
  float passed = outer.weight > 0.0 ? (beyond.core.weight + beyond.rest.weight) / outer.weight : 0.0;
  ComposedLobe aside = pair.rest;
  aside.direction = normalize(pair.rest.direction + beyond.core.direction - pair.core.direction);
  aside.weight *= passed;
  beyond.rest = mergeLobes(beyond.rest, aside);
  second.pair = beyond;
  second.origin = way.point;
  second.passed = exp(-way.exit.path * body.attenuation);
  float cosTheta = dot(outer.direction, front.exit.surface.n);
  float alpha = front.exit.surface.alpha;
  float weight = (pair.core.weight + pair.rest.weight) * engineFaceEnergy(cosTheta, alpha, body.ior).reflected;
  vec3 mirrored = outer.direction - 2.0 * cosTheta * front.exit.surface.n;
  second.reflected = weight * engineEnvironment(mirrored, min(sqrt(outer.sigma * outer.sigma + 4.0 * alpha * alpha), 0.606));
  return second;
}

vec3 refractTwoPairs(GlassFace face, ConvexBody body, float number, SceneView view, Widening k) {
  Entering entered = enterGlass(face, body.ior);
  WaysOut ways = waysOut(face, body, entered, SECOND_BACKS, number, REFLECTIONS_INSIDE, view);
  entered.core = ways.core.lobe;
  entered.tail = ways.tail.lobe;
  ConvexExit exit = ways.core.exit;
  Leaving left = leaveGlass(face, body, entered, exit, ways.tail.exit, k);
  SecondBody second = throughSecondBody(left.pair, ways.core.point, exit.path, body, view, k);
  vec3 sum = second.passed * pairRadiance(second.pair, second.origin, second.inside, view) + second.reflected;
  return sum * exp(-exit.path * body.attenuation)
         + internallyReflected(face, body, entered.core, entered.energy, exit, left.passed);
}

#endif
