// exit_steps_fetch.glsl: Newton's steps to where a ray inside glass leaves it, in interior layers.
// Frame    world, metres; those of exit_surface.glsl and interior_fetch.glsl.
// alpha    none.
// Returns  exitInsideAt: exitInside of a place of the picture, EXIT_NOWHERE outside of it.
//          exitIntersection: of the surfaces at a place that the ray can meet from inside between tLow and tHigh, the one whose
//          plane it meets nearest to t. exitSteps: from t on to the plane that the texel there shows, until the next is the same.
// Source   exit_search.glsl.
// Limits   the place given to exitIntersection must lie in the picture.
#ifndef GG_REFRACTION_EXIT_STEPS_FETCH_GLSL
#define GG_REFRACTION_EXIT_STEPS_FETCH_GLSL

#include "refraction/interior_fetch.glsl"

vec2 exitInsideAt(usampler2DArray interior, int pairs, InteriorView view, vec4 at, float solid) {
  if (!exitOnPicture(view, at)) return vec2(EXIT_NOWHERE);
  return exitInside(exitStretches(interiorDepths(interior, pairs, ivec2(at.xy), solid)), at.z);
}

struct ExitIntersection {
  float t; // -1: there is none
  int layer;
  vec2 inside; // exitInside at the place
};

ExitIntersection exitIntersection(usampler2DArray interior, int pairs, InteriorView view, vec4 place, float solid, vec3 origin,
                        vec3 direction, float t, float tLow, float tHigh) {
  ivec2 at = ivec2(place.xy);
  uvec4 bits[4];
  vec4 depths = vec4(0.0);
  for (int layer = 0; layer < 2 * pairs; ++layer) {
    bits[layer] = texelFetch(interior, ivec3(at, layer), 0);
    depths[layer] = interiorNumber(bits[layer]) == solid ? uintBitsToFloat(bits[layer].x) : 0.0;
  }
  vec4 stretches = exitStretches(depths);
  ExitIntersection best;
  best.t = -1.0;
  best.layer = INTERIOR_B1;
  best.inside = exitInside(stretches, place.z);
  bool overlap = stretches.y != depths.y; // B1 and F2 lie inside of another body
  for (int layer = 0; layer < 2 * pairs; ++layer) {
    if (depths[layer] == 0.0 || (overlap && (layer == 1 || layer == 2))) continue;
    InteriorSurface s = interiorSurface(view, bits[layer], at);
    float own = exitPlane(origin, direction, s.point, s.n);
    if (dot(direction, s.n) > 0.0 && own > tLow && own < tHigh && (best.t < 0.0 || abs(own - t) < abs(best.t - t))) {
      best.t = own;
      best.layer = layer;
    }
  }
  return best;
}

struct ExitSteps {
  float t; // -1: nothing was met
  int layer;
  float reads;
};

// Between its ends, if both are known, the crossing is closed in on; where a texel shows nothing to step to, by halves. From a
// bare guess nothing is learned: the ray may have been outside on the way to it.
ExitSteps exitSteps(usampler2DArray interior, int pairs, InteriorView view, ExitRay ray, float solid, vec3 origin, vec3 direction,
                    float t, ExitWay way) {
  bool closed = way.tOutside < EXIT_FAR;
  ExitSteps s;
  s.t = -1.0;
  s.layer = INTERIOR_B1;
  s.reads = 0.0;
  for (int k = 0; k < (closed ? 5 : 3); ++k) {
    vec4 at = exitAt(ray, t);
    s.t = -1.0;
    if (exitOnPicture(view, at)) {
      // A texel shows a point up to half of it away, so that its plane may be met as far before or behind the ends.
      vec2 speed = (ray.direction.xy - at.xy * ray.direction.w) / at.w;
      float room = closed ? min(inversesqrt(dot(speed, speed)), way.tOutside - way.tInside) : 0.0;
      ExitIntersection met = exitIntersection(interior, pairs, view, at, solid, origin, direction, t, way.tInside - room,
                                    way.tOutside + room);
      s.reads += 1.0;
      s.t = met.t;
      s.layer = met.layer;
      vec2 moved = exitAt(ray, met.t).xy - at.xy;
      if (met.t > 0.0 && dot(moved, moved) < 1.0) break; // exitRead sees both texels
      if (closed) way = exitLearn(way, t, at.w, max(met.inside.x, met.inside.y), interiorTexelDepth(view, at.z));
    } else if (closed) {
      way.tOutside = t;
    }
    if (!closed && s.t < 0.0) break;
    t = s.t > 0.0 ? s.t : 0.5 * (way.tInside + way.tOutside);
  }
  return s;
}

#endif
