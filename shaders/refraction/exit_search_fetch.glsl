// exit_search_fetch.glsl: finds where a ray inside glass leaves it, in interior layers.
// Frame    world, metres; those of exit_surface.glsl and interior_fetch.glsl.
// alpha    ExitHit: width of D of the surface met, in [0, 1].
// Returns  findExit: where the ray next meets the solid's surface from inside, see ExitHit; never NaN. `direction` is unit;
//          `guess`: about how far, metres, the own thickness (interiorThickness) for a first segment; `afterBounce`: the ray
//          starts on a surface that reflected it.
// Source   exit_search.glsl. Plane steps (Newton's, with the stored normal) from the guess, believed if three places on the way
//          are inside; else steps outwards and two secants. Accepted only where the surface faces along the ray.
// Limits   pairs 1: F1 and B1, exact for convex bodies; 2: the pair behind too. What is narrower than a texel or outside the
//          picture is not found.
#ifndef GG_REFRACTION_EXIT_SEARCH_FETCH_GLSL
#define GG_REFRACTION_EXIT_SEARCH_FETCH_GLSL

#include "refraction/exit_read_fetch.glsl"

float exitInsideAt(usampler2DArray interior, int pairs, InteriorView view, vec4 at, float solid) {
  if (!exitOnPicture(view, at)) return EXIT_NOWHERE;
  return exitInside(interiorDepths(interior, pairs, ivec2(at.xy), solid), at.z, 2.0 * interiorTexelDepth(view, at.z));
}

// What is known of the way: inside up to tInside, outside at tOutside.
struct ExitWay {
  float tInside;
  float inside;  // exitInside times w there: linear in t where the surface is flat
  float tOutside;
  float outside;
  int steps;     // of the march, so far
  bool open;     // the march has come inside since the last crossing
  float reads;
};

const float EXIT_FAR = 1.0e30; // nothing is known to be outside

ExitWay exitLearn(ExitWay way, float t, float w, float here, float least) {
  if (here > least) {
    way.tInside = t;
    way.inside = here * w;
  } else if (here < -least) {
    way.tOutside = t;
    way.outside = here > EXIT_NOWHERE ? here * w : EXIT_NOWHERE;
  }
  return way;
}

struct ExitSteps {
  float t; // negative: nothing was met
  int layer;
  ExitWay way;
};

// Newton's steps along the ray from t: to the plane that the texel there shows, and on from there, between what is known to
// be inside and outside. Within a texel's width of the surface neither is known; and without an end the way to t may have been
// outside in between, so that nothing is learned of it.
ExitSteps exitSteps(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, vec3 origin, vec3 direction,
                    float t, ExitWay way) {
  ExitSteps s;
  s.t = -1.0;
  s.layer = INTERIOR_B1;
  s.way = way;
  ivec2 last = ivec2(-1);
  bool bracketed = way.tOutside < EXIT_FAR;
  for (int k = 0; k < (bracketed ? 5 : 3); ++k) {
    vec4 at = exitAt(ray, t);
    if (exitOnPicture(view, at)) {
      if (s.t > 0.0 && ivec2(at.xy) == last) break; // the same texel shows the same plane
      last = ivec2(at.xy);
      InteriorMeeting met = interiorMeeting(interior, pairs, view, at.xyz, solid, origin, direction, t, s.way.tInside, s.way.tOutside);
      if (bracketed) s.way = exitLearn(s.way, t, at.w, met.inside, interiorTexelDepth(view, at.z));
      s.way.reads += 1.0;
      s.t = met.t;
      s.layer = met.layer;
    } else {
      if (bracketed) s.way = exitLearn(s.way, t, 1.0, EXIT_NOWHERE, 0.0);
      s.t = -1.0;
    }
    if (!bracketed && s.t < 0.0) break;
    if (s.t <= s.way.tInside || s.t >= s.way.tOutside) s.t = -1.0;
    t = s.t > 0.0 ? s.t : 0.5 * (s.way.tInside + s.way.tOutside);
  }
  return s;
}

// Onwards to the next crossing; tOutside stays EXIT_FAR if none is met.
ExitWay exitMarch(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, float first, float unit,
                  ExitWay way) {
  way.tOutside = EXIT_FAR;
  while (way.steps < EXIT_STEPS && way.tOutside == EXIT_FAR) {
    float t = first + unit * exitSpacing(++way.steps);
    vec4 at = exitAt(ray, t);
    float here = exitInsideAt(interior, pairs, view, at, solid);
    way.reads += 1.0;
    if (here > 0.0 || way.open) way = exitLearn(way, t, at.w, here, 0.0);
    if (here > 0.0) way.open = true;
  }
  return way;
}

ExitHit findExit(usampler2DArray interior, InteriorView view, int pairs, float solid, vec3 origin, vec3 direction, float guess,
                 bool afterBounce) {
  ExitRay ray = exitRay(view, origin, direction);
  float texel = interiorTexelWidth(view, ray.origin.w);
  float first = afterBounce ? 1.5 * texel : 0.0; // or the ray would meet the surface that it starts from
  float unit = max(guess, texel);
  vec4 start = exitAt(ray, first);
  // The way before says little of the way on, if it was short: what lies behind the bounce's own place says more.
  if (afterBounce && exitOnPicture(view, start))
    unit = max(unit, interiorThickness(interior, view, ivec2(start.xy), solid));
  ExitWay way;
  way.tInside = first;
  way.inside = 0.0;
  way.tOutside = EXIT_FAR;
  way.outside = EXIT_NOWHERE;
  way.steps = 0;
  way.open = true;
  way.reads = 0.0;
  float lastInside = first;
  ExitHit hit = exitNone(origin, direction);
  // Round 0: plane steps from the guess. Then the crossings that a march meets, until one faces along the ray: two at most.
  for (int round = 0; round < 3 && hit.found == 0.0 && way.steps < EXIT_STEPS; ++round) {
    float t = first + unit;
    ExitWay known = way;
    if (round > 0) {
      way = exitMarch(interior, pairs, view, ray, solid, first, unit, way);
      lastInside = way.tInside;
      if (way.tOutside == EXIT_FAR) break;
      way.open = false;
      known = way;
      t = exitSecant(way.tInside, way.inside, way.tOutside, way.outside);
    }
    ExitSteps s = exitSteps(interior, pairs, view, ray, solid, origin, direction, t, known);
    way.reads = s.way.reads;
    bool believed = s.t > 0.0;
    for (int k = 1; round == 0 && believed && k < 4; ++k) {
      vec4 at = exitAt(ray, mix(first, s.t, 0.25 * float(k)));
      believed = exitInsideAt(interior, pairs, view, at, solid) > 0.0;
      way.reads += 1.0;
    }
    if (!believed) continue;
    hit = exitRead(interior, s.layer, view, ray, solid, origin, direction, s.t);
    way.reads += 4.0;
  }
  hit.reads = way.reads;
  if (hit.found == 0.0) hit.point = origin + lastInside * direction;
  return hit;
}

#endif
