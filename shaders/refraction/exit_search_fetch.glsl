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

struct ExitMarch {
  float first, unit;        // the k-th step looks at first + unit exitSpacing(k)
  float tInside, inside;    // the last place known to be inside; exitInside times w there
  float tOutside, outside;
  bool open;                // the way so far ends inside
  int steps;
  float reads;
};

// Onwards to the next crossing, then two secants between its ends. tOutside is negative if none was met.
ExitMarch exitMarch(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, ExitMarch m) {
  m.tOutside = -1.0;
  int secants = 0;
  while (secants < 2 && (m.steps < EXIT_STEPS || m.tOutside >= 0.0)) {
    bool crossed = m.tOutside >= 0.0;
    if (crossed) ++secants;
    else ++m.steps;
    float t = crossed ? exitSecant(m.tInside, m.inside, m.tOutside, m.outside) : m.first + m.unit * exitSpacing(m.steps);
    vec4 at = exitAt(ray, t);
    float here = exitInsideAt(interior, pairs, view, at, solid);
    m.reads += 1.0;
    if (here > 0.0) {
      m.tInside = t;
      m.inside = here * at.w;
      m.open = true;
    } else if (m.open) {
      m.tOutside = t;
      m.outside = here > EXIT_NOWHERE ? here * at.w : EXIT_NOWHERE;
    }
  }
  return m;
}

struct ExitSteps {
  float t; // negative: nothing to meet
  int layer;
  float reads;
};

// Newton's steps along the ray: to the plane that the texel at t shows, and on from there.
ExitSteps exitSteps(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, vec3 origin, vec3 direction,
                    float t, float first, int count) {
  ExitSteps s;
  s.t = t;
  s.layer = INTERIOR_B1;
  s.reads = 0.0;
  ivec2 last = ivec2(-1);
  for (int k = 0; k < count && s.t > first; ++k) {
    vec4 at = exitAt(ray, s.t);
    if (!exitOnPicture(view, at)) s.t = -1.0;
    if (s.t < 0.0 || ivec2(at.xy) == last) break; // the same texel shows the same plane
    last = ivec2(at.xy);
    InteriorMeeting met = interiorMeeting(interior, pairs, view, last, solid, origin, direction, s.t);
    s.t = met.t;
    s.layer = met.layer;
    s.reads += 1.0;
  }
  if (s.t <= first) s.t = -1.0;
  return s;
}

ExitHit findExit(usampler2DArray interior, InteriorView view, int pairs, float solid, vec3 origin, vec3 direction, float guess,
                 bool afterBounce) {
  ExitRay ray = exitRay(view, origin, direction);
  float texel = interiorTexelWidth(view, ray.origin.w);
  ExitMarch march;
  march.first = afterBounce ? 1.5 * texel : 0.0; // or the ray would meet the surface that it starts from
  march.unit = max(guess, texel);
  march.tInside = march.first;
  march.inside = 0.0;
  march.tOutside = -1.0;
  march.outside = EXIT_NOWHERE;
  march.open = true;
  march.steps = 0;
  march.reads = 0.0;
  ExitHit hit = exitNone(origin, direction);
  // Round 0: plane steps from the guess. Then the crossings that a march meets, until one faces along the ray: two at most.
  for (int round = 0; round < 3 && hit.found == 0.0 && march.steps < EXIT_STEPS; ++round) {
    float t = march.first + march.unit;
    if (round > 0) {
      march = exitMarch(interior, pairs, view, ray, solid, march);
      if (march.tOutside < 0.0) break;
      t = 0.5 * (march.tInside + march.tOutside);
      march.open = false;
    }
    ExitSteps s = exitSteps(interior, pairs, view, ray, solid, origin, direction, t, march.first, round == 0 ? 3 : 1);
    march.reads += s.reads;
    bool believed = s.t > 0.0;
    for (int k = 1; round == 0 && believed && k < 4; ++k) {
      vec4 at = exitAt(ray, mix(march.first, s.t, 0.25 * float(k)));
      believed = exitInsideAt(interior, pairs, view, at, solid) > 0.0;
      march.reads += 1.0;
    }
    if (!believed) continue;
    hit = exitRead(interior, s.layer, view, ray, solid, origin, direction, s.t);
    march.reads += 4.0;
  }
  hit.reads = march.reads;
  if (hit.found == 0.0) hit.point = origin + march.tInside * direction;
  return hit;
}

#endif
