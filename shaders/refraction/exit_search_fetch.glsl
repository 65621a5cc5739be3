// exit_search_fetch.glsl: finds where a ray inside glass leaves it, in interior layers.
// Frame    world, metres; those of exit_surface.glsl and interior_fetch.glsl.
// alpha    ExitHit: width of D of the surface met, in [0, 1].
// Returns  findExit: where the ray next meets the solid's surface from inside, see ExitHit; never NaN. `direction` is unit;
//          `guess`: about how far, metres, the own thickness (interiorThickness) for a first segment; `afterBounce`: the ray
//          starts on a surface that reflected it.
// Source   exit_search.glsl. Plane steps from the guess, believed (unless the body is convex) if three places on the way are
//          inside and show nothing to meet before; else steps outwards to a crossing. Accepted only where the surface faces
//          along the ray.
// Limits   pairs 1: F1 and B1, of a body that is convex or taken to be; 2: the pair behind too. What is narrower than a texel or
//          outside the picture is not found.
#ifndef GG_REFRACTION_EXIT_SEARCH_FETCH_GLSL
#define GG_REFRACTION_EXIT_SEARCH_FETCH_GLSL

#include "refraction/exit_read_fetch.glsl"
#include "refraction/exit_steps_fetch.glsl"

struct ExitMarch {
  float first; // the k-th step looks at first + unit exitSpacing(k)
  float unit;
  int steps;
  int stretch; // of the last place inside: 1 or 2; 0: not known
  bool open;   // a place inside has been seen since the last crossing
  ExitWay way;
  float reads;
};

int exitStretch(vec2 inside) { return inside.x >= inside.y ? 1 : 2; }

// Onwards to the next crossing: out, or over into the other stretch, as a gap may lie between the two.
ExitMarch exitOnwards(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, ExitMarch m) {
  m.way.tOutside = EXIT_FAR;
  while (m.steps < EXIT_STEPS && m.way.tOutside == EXIT_FAR) {
    float t = m.first + m.unit * exitSpacing(++m.steps);
    vec4 at = exitAt(ray, t);
    vec2 both = exitInsideAt(interior, pairs, view, at, solid);
    float here = max(both.x, both.y);
    float margin = 2.0 * interiorTexelDepth(view, at.z);
    bool within = here > margin;
    bool over = within && m.open && m.stretch != 0 && exitStretch(both) != m.stretch;
    m.reads += 1.0;
    if (over) {
      m.way.tOutside = t;
      m.way.outside = EXIT_NOWHERE;
    } else if (within || m.open) {
      m.way = exitLearn(m.way, t, at.w, here, margin);
    }
    if (within) m.stretch = exitStretch(both);
    m.open = within || (m.open && m.way.tOutside == EXIT_FAR);
  }
  return m;
}

struct ExitDoubt {
  bool believed;
  float earlier; // where something is met before; -1: nowhere
  float reads;
};

// Whether the ray can have come to t through the inside alone: asked at three places on the way.
ExitDoubt exitDoubt(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, vec3 origin, vec3 direction,
                    float t, float first, int stretch) {
  ExitDoubt doubt;
  doubt.believed = true;
  doubt.earlier = -1.0;
  doubt.reads = 0.0;
  vec2 end = exitAt(ray, t).xy;
  for (int k = 1; k < 4 && doubt.believed; ++k) {
    float place = mix(first, t, 0.25 * float(k));
    vec4 at = exitAt(ray, place);
    doubt.believed = exitOnPicture(view, at);
    if (!doubt.believed) break;
    ExitIntersection met = exitIntersection(interior, pairs, view, at, solid, origin, direction, place, place, t);
    doubt.reads += 1.0;
    if (stretch == 0) stretch = exitStretch(met.inside);
    vec2 apart = exitAt(ray, met.t).xy - end;
    if (met.t > 0.0 && dot(apart, apart) > 4.0) doubt.earlier = met.t; // two texels: no matter of rounding to texels
    doubt.believed = max(met.inside.x, met.inside.y) > -2.0 * interiorTexelDepth(view, at.z) &&
                     exitStretch(met.inside) == stretch && doubt.earlier < 0.0;
  }
  return doubt;
}

ExitHit findExit(usampler2DArray interior, InteriorView view, int pairs, float solid, vec3 origin, vec3 direction, float guess,
                 bool afterBounce) {
  ExitRay ray = exitRay(view, origin, direction);
  float texel = interiorTexelWidth(view, ray.origin.w);
  ExitMarch march;
  march.first = afterBounce ? 1.5 * texel : 0.0; // or the ray would meet the surface that it starts from
  march.unit = max(guess, texel);
  // A short way before a bounce says little of the way on: what lies behind the bounce's own place says more.
  vec4 start = exitAt(ray, march.first);
  if (afterBounce && exitOnPicture(view, start))
    march.unit = max(march.unit, interiorThickness(interior, view, ivec2(start.xy), solid));
  march.steps = 0;
  march.stretch = afterBounce ? 0 : 1;
  march.open = true;
  march.way.tInside = march.first;
  march.way.inside = 0.0;
  march.way.tOutside = EXIT_FAR;
  march.way.outside = EXIT_NOWHERE;
  march.reads = 0.0;
  ExitHit hit = exitNone(origin, direction);
  float guessed = march.first + march.unit; // where to step from; -1: nowhere, march
  for (int round = 0; round < 5 && hit.found == 0.0 && march.steps < EXIT_STEPS; ++round) {
    float t = guessed;
    if (guessed < 0.0) {
      march = exitOnwards(interior, pairs, view, ray, solid, march);
      if (march.way.tOutside == EXIT_FAR) break;
      t = exitSecant(march.way);
    }
    ExitSteps s = exitSteps(interior, pairs, view, ray, solid, origin, direction, t, march.way);
    march.reads += s.reads;
    bool believed = s.t > 0.0;
    if (guessed > 0.0 && believed && pairs > 1) { // a convex body is left once
      ExitDoubt doubt = exitDoubt(interior, pairs, view, ray, solid, origin, direction, s.t, march.first, march.stretch);
      march.reads += doubt.reads;
      believed = doubt.believed;
      guessed = round < 2 ? doubt.earlier : -1.0;
    } else {
      guessed = -1.0;
    }
    if (!believed) continue;
    hit = exitRead(interior, s.layer, view, ray, solid, origin, direction, s.t);
    march.reads += 4.0;
  }
  hit.reads = march.reads;
  if (hit.found == 0.0) hit.point = origin + march.way.tInside * direction;
  return hit;
}

#endif
