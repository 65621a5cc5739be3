// exit_search.glsl: where a ray inside glass leaves it, seen only through layers of depth and normals: the steps of the search.
// Frame    that of exit_surface.glsl; t in metres along the ray, whose direction is unit.
// alpha    none.
// Returns  exitRay, exitAt: the ray in the picture: x, y in texels, depth, and the w of clip space (<= 0: behind the camera).
//          exitInside: > 0 inside the solid, by how much depth; EXIT_NOWHERE where the layers hold nothing.
//          exitSecant: the zero between a point inside and one outside. exitSpacing: the k-th of EXIT_STEPS distances to look
//          at, in units of the guess. exitPlane: t at which the ray meets the plane of a surface.
//          exitSame: whether two texels belong to one smooth surface. exitCurvature: normal curvatures in the plane of the ray
//          and across it, 1/m, positive where the solid bulges; 0 where the texels do not resolve them.
// Source   [Wyman05] for refraction by layers of front and back faces; the search was chosen by ray casting nine meshes.
// Limits   two pairs of layers; exact for planes.
#ifndef GG_REFRACTION_EXIT_SEARCH_GLSL
#define GG_REFRACTION_EXIT_SEARCH_GLSL

#include "refraction/exit_surface.glsl"

const float EXIT_NOWHERE = -2.0; // depths lie in 0 .. 1, so nothing measured is as low
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

// depths: F1, B1, F2, B2, 0 where there is none. `slack`: depth by which front faces are moved towards the viewer, since the
// texel that a ray starts in shows a point of its surface up to half a texel away.
float exitInside(vec4 depths, float depth, float slack) {
  // Before the nearest front face there is a back face: the camera stands in the glass, and F1 opens the second pair.
  bool within = depths.x < depths.y;
  float front1 = within ? 2.0 : depths.x + slack; // 2: nearer than everything
  float front2 = (within ? depths.x : depths.z) + slack;
  float inside = EXIT_NOWHERE;
  if (depths.y > 0.0) inside = min(front1 - depth, depth - depths.y);
  if (depths.w > 0.0) inside = max(inside, min(front2 - depth, depth - depths.w));
  return inside;
}

// inside, outside: exitInside there. Times w both are linear in t where the surface is flat: a secant then ends on it.
// Where nothing was met outside, and so that no step stands still, the zero is looked for in the middle nine tenths.
float exitSecant(float tInside, float inside, float tOutside, float outside) {
  float share = outside <= EXIT_NOWHERE ? 0.5 : clamp(inside / (inside - outside), 0.05, 0.95);
  return mix(tInside, tOutside, share);
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
  if (dot(along, along) < 1.0e-12) along = stepX - dot(stepX, n) * n;
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
