// exit_search.glsl: where a ray inside glass leaves it, seen only through layers of depth and normals: the steps of the search.
// Frame    that of exit_surface.glsl; t in metres along the ray, whose direction is unit.
// alpha    none.
// Returns  exitRay, exitAt: the ray in the picture: x, y in texels, depth, and the w of clip space (<= 0: behind the camera).
//          exitStretches, exitInside: the parts of a line of sight that are inside, and how deep in each a place is.
//          exitLearn: a place more that is known. exitSecant: where between its ends a crossing is likely.
//          exitSpacing: the k-th of EXIT_STEPS distances to look at, in units of the guess.
//          exitPlane: t at which the ray meets the plane of a surface.
//          exitSame: whether two texels belong to one smooth surface. exitCurvature: normal curvatures in the plane of the ray
//          and across it, 1/m, positive where the solid bulges; 0 where the texels do not resolve them.
// Source   [Wyman05] for refraction by layers of front and back faces; the search was chosen by ray casting nine meshes.
// Limits   two pairs of layers; exact for planes.
#ifndef GG_REFRACTION_EXIT_SEARCH_GLSL
#define GG_REFRACTION_EXIT_SEARCH_GLSL

#include "bsdf/constants.glsl"
#include "refraction/exit_surface.glsl"

const float EXIT_NOWHERE = -2.0; // inside by less than any depth: nothing is there
const float EXIT_FAR = 1.0e30;   // beyond everything
const int EXIT_STEPS = 12;

struct ExitRay {
  vec4 origin;    // texels and depth times w, w
  vec4 direction; // per metre
};

ExitRay exitRay(InteriorView view, vec3 origin, vec3 direction) {
  vec4 o = view.clipFromWorld * vec4(origin, 1.0);
  vec4 d = view.clipFromWorld * vec4(direction, 0.0);
  vec2 h = 0.5 * view.size;
  ExitRay ray;
  ray.origin = vec4(h.x * (o.w + o.x), h.y * (o.w - o.y), o.z, o.w);
  ray.direction = vec4(h.x * (d.w + d.x), h.y * (d.w - d.y), d.z, d.w);
  return ray;
}

vec4 exitAt(ExitRay ray, float t) {
  vec4 p = ray.origin + t * ray.direction;
  float s = 1.0 / p.w;
  return vec4(p.x * s, p.y * s, p.z * s, p.w);
}

bool exitOnPicture(InteriorView view, vec4 at) {
  return at.w > 0.0 && at.x >= 0.0 && at.y >= 0.0 && at.x < view.size.x && at.y < view.size.y;
}

// depths: F1, B1, F2, B2, 0 where there is none. Returns front and back of the first stretch that is inside, then of the second.
vec4 exitStretches(vec4 depths) {
  // Before the nearest front face there is a back face: the camera stands in the glass, and F1 opens the second stretch.
  if (depths.x < depths.y) return vec4(2.0, depths.y, depths.x, depths.w); // 2: nearer than everything
  // The second front face before the first back face: two bodies overlap, what lies between is inside of both.
  if (depths.z > depths.y && depths.w > 0.0) return vec4(depths.x, depths.w, 0.0, 0.0);
  return depths;
}

vec2 exitInside(vec4 stretches, float depth) {
  vec2 inside = vec2(EXIT_NOWHERE);
  if (stretches.y > 0.0) inside.x = min(stretches.x - depth, depth - stretches.y);
  if (stretches.w > 0.0) inside.y = min(stretches.z - depth, depth - stretches.w);
  return inside;
}

// What is known of the ray: inside at tInside, outside (or inside again, past a gap) at tOutside.
struct ExitWay {
  float tInside;
  float inside;   // exitInside times w: linear in t where the surface is flat
  float tOutside; // EXIT_FAR: not known
  float outside;  // not above 0
};

// here: exitInside. Within `margin` of the surface a texel's point, up to half a texel away, does not tell inside from outside.
ExitWay exitLearn(ExitWay way, float t, float w, float here, float margin) {
  if (here > margin) {
    way.tInside = t;
    way.inside = here * w;
  } else if (here < -margin) {
    way.tOutside = t;
    way.outside = here > EXIT_NOWHERE ? here * w : EXIT_NOWHERE;
  }
  return way;
}

// In the middle where nothing was met outside, and not at an end, where the step would stand still.
float exitSecant(ExitWay way) {
  float share = way.outside > EXIT_NOWHERE ? clamp(way.inside / (way.inside - way.outside), 0.05, 0.95) : 0.5;
  return mix(way.tInside, way.tOutside, share);
}

// Dense about the guess, then ever wider: to 48 times the guess at the last step. A path through a ball that starts 5 degrees
// from its outline is 8.5 times as long as the ball is thick there, at 1 degree 43 times.
float exitSpacing(int k) {
  float x = 0.25 * float(k);
  float x3 = x * x * x;
  return x + x3 / 3.0 + x3 * x3 / 20.0;
}

float exitPlane(vec3 origin, vec3 direction, vec3 point, vec3 n) { return dot(point - origin, n) / dot(direction, n); }

// Along a smooth surface whose normal turns by less than 45 degrees from one texel to the next (cosine .7), a chord stands at
// most half that angle off the tangent plane (sine .39).
bool exitSame(vec3 point, vec3 n, vec3 otherPoint, vec3 otherN) {
  vec3 chord = otherPoint - point;
  return dot(n, otherN) > 0.7 && abs(dot(chord, n)) <= 0.39 * length(chord);
}

// step, turn: how point and normal change over one texel to the right and down.
vec2 exitCurvature(vec3 n, vec3 direction, vec3 stepX, vec3 turnX, vec3 stepY, vec3 turnY) {
  float area = dot(cross(stepX, stepY), n);
  // A normal that turns by more than a quarter within one texel shows an edge, or a bend of fewer than four texels' radius.
  float turn = max(dot(turnX, turnX), dot(turnY, turnY));
  if (area == 0.0 || turn > 0.0625) return vec2(0.0);
  // A ray along n has no plane: that of stepX will do.
  vec3 along = direction - dot(direction, n) * n;
  if (dot(along, along) < LEAST_LENGTH2) along = stepX - dot(stepX, n) * n;
  vec3 t1 = normalize(along);
  vec3 t2 = cross(n, t1);
  vec3 turn1 = (dot(stepY, t2) * turnX - dot(stepX, t2) * turnY) / area;
  vec3 turn2 = (dot(stepX, t1) * turnY - dot(stepY, t1) * turnX) / area;
  // The normals of a surface turn symmetrically (Weingarten's map); what does not is a normal map or noise.
  float twist = abs(dot(turn1, t2) - dot(turn2, t1));
  vec2 curvature = vec2(dot(turn1, t1), dot(turn2, t2));
  return twist > abs(curvature.x) + abs(curvature.y) ? vec2(0.0) : curvature;
}

#endif
