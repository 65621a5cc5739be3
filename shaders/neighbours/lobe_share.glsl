// lobe_share.glsl: the share of a Gaussian lobe that a sphere or a rectangle occludes, and where it is met.
// Frame    any, the receiver's point at the origin; directions unit, lengths metres.
// alpha    none; sigma: radians per axis, clamped to [0.01, 0.65]: exp(-l(l+1) sigma²/2) on the sphere.
// Returns  sphereShare, rectangleShare: share in [0, 1] of the lobe; mean direction of that part, its own width, the point where
//          this direction meets the proxy as a distance along it, and the normal there on the receiver's side.
//          0 where nothing is met; a point within the sphere sees it fade out from its surface to 0.8 of the radius.
// Source   sphere: exact on its axis and for great circles; off it the disc is taken for a strip whose edges are drawn in by the
//          curvature of its outline (a half-plane whose edge has geodesic curvature cot rho, to first order). Rectangle: the part
//          of the lobe below its plane's horizon is a Gaussian of that part's mean and variance, cut by the great circles of
//          the four edges, those opposite each other exactly. Normal integral [Page77].
// Limits   rms / worst error of the share over radii and angles, against the series and against quadrature (tests/neighbours):
//          sphere .004 / .017 for sigma up to .35, .015 / .036 at .65; rectangle .03 / .18 for sigma up to .35, .053 / .17 at
//          .65, worst where it is seen along its plane, a corner first.
#ifndef GG_NEIGHBOURS_LOBE_SHARE_GLSL
#define GG_NEIGHBOURS_LOBE_SHARE_GLSL

#include "bsdf/constants.glsl"

const float LEAST_LOBE = 0.01; // radians: below it a share is an edge, no wider than a pixel of most pictures

struct LobeShare {
  float share;
  vec3 direction; // of the middle of what is met
  float sigma;    // of that part, radians
  float distance; // metres along the direction
  vec3 n;         // where it is met
};

LobeShare noShare(vec3 direction) {
  LobeShare s;
  s.share = 0.0;
  s.direction = direction;
  s.sigma = 0.0;
  s.distance = 0.0;
  s.n = -direction;
  return s;
}

// The normal distribution's integral, to 2e-4; past 6 sigma it is 0 or 1 in floats.
float lobeIntegral(float x) {
  float t = clamp(x, -6.0, 6.0);
  return 1.0 / (1.0 + exp(-t * (1.5957691 + 0.0715628 * t * t)));
}

LobeShare sphereShare(vec3 centre, float radius, vec3 direction, float sigma) {
  float s = clamp(sigma, LEAST_LOBE, 0.65);
  float range = length(centre);
  if (!(range > 0.8 * radius)) return noShare(direction);
  vec3 axis = centre / range;
  float sinRho = clamp(radius / range, 1e-6, 0.999); // a millionth is nothing
  float rho = asin(sinRho);
  float theta = 2.0 * asin(min(0.5 * length(direction - axis), 1.0));
  LobeShare found = noShare(direction);
  if (theta > rho + 4.0 * s) return found;
  float u2 = rho * rho / (s * s);
  float curved = 0.9 * rho * sqrt(1.0 - sinRho * sinRho) / sinRho;
  float reach = rho * sqrt((u2 + 1.0) / (u2 + 1.0 + curved)) / s;
  float middle = max(2.0 * lobeIntegral(reach) - 1.0, LEAST_WEIGHT);
  float beside = lobeIntegral(reach - theta / s) - lobeIntegral(-reach - theta / s);
  found.share = (1.0 - exp(-0.5 * u2)) * clamp(beside / middle, 0.0, 1.0) * smoothstep(0.8, 1.0, range / radius);
  // A product of two Gaussians: the lobe and the disc, which has a quarter of its squared radius per axis.
  float disc = 0.25 * rho * rho;
  float off = min(theta * disc / (disc + s * s), 0.98 * rho);
  vec3 towards = direction - dot(direction, axis) * axis;
  float side = length(towards);
  if (side > LEAST_LENGTH) found.direction = cos(off) * axis + (sin(off) / side) * towards;
  float across = range * sin(off);
  found.distance = max(range * cos(off) - sqrt(max(radius * radius - across * across, 0.0)), 0.0);
  found.n = normalize(found.distance * found.direction - centre);
  found.sigma = min(s, 0.5 * rho);
  return found;
}

// The share on the inner side of a great circle with that normal; `along` is the deviation where it runs level with the horizon.
float withinEdge(vec3 edge, vec3 direction, vec3 along, vec3 beside, float below, float s, vec3 n, float horizon) {
  vec3 inward = edge * inversesqrt(max(dot(edge, edge), LEAST_DIVISOR));
  vec2 width = vec2(below * dot(inward, along), s * dot(inward, beside));
  float share = lobeIntegral(dot(inward, direction) / max(length(width), 0.01 * LEAST_LOBE));
  // What the horizon has cut off already an edge that lies along it must not cut again.
  return min(share / mix(1.0, horizon, clamp(-dot(inward, n), 0.0, 1.0)), 1.0);
}

// u, v: half of its sides, metres. Both of its faces are met.
LobeShare rectangleShare(vec3 centre, vec3 u, vec3 v, vec3 direction, float sigma) {
  float s = clamp(sigma, LEAST_LOBE, 0.65);
  LobeShare found = noShare(direction);
  vec3 n = normalize(cross(u, v));
  float facing = dot(n, centre) > 0.0 ? -1.0 : 1.0;
  n *= facing;
  float height = -dot(centre, n);
  float sinDown = clamp(-dot(direction, n), -1.0, 1.0);
  float z = asin(sinDown) / s;
  // A point in the plane, to a hundred roundings of where it is, does not see its front.
  if (!(height > 1e-5 * length(centre)) || z < -4.0) return found;
  float below = lobeIntegral(z);
  float shift = 0.3989423 * exp(-0.5 * z * z) / below;
  float down = clamp(asin(sinDown) + s * shift, 0.02, 1.5707963);
  float width = s * sqrt(max(1.0 - z * shift - shift * shift, 0.05));
  vec3 level = direction + sinDown * n;
  level = dot(level, level) > LEAST_COSINE * LEAST_COSINE ? normalize(level) : normalize(u);
  vec3 middle = cos(down) * level - sin(down) * n;
  vec3 along = -sin(down) * level - cos(down) * n;
  vec3 beside = cross(level, n);
  float horizon = lobeIntegral(sin(down) / width);
  vec3 a = facing * u;
  float right = withinEdge(-cross(centre + u, facing * v), middle, along, beside, width, s, n, horizon);
  float left = withinEdge(cross(centre - u, facing * v), middle, along, beside, width, s, n, horizon);
  float upper = withinEdge(cross(centre + v, a), middle, along, beside, width, s, n, horizon);
  float lower = withinEdge(-cross(centre - v, a), middle, along, beside, width, s, n, horizon);
  found.share = below * max(right + left - 1.0, 0.0) * max(upper + lower - 1.0, 0.0);
  // Met within its sides.
  vec3 at = (height / sin(down)) * middle - centre;
  vec3 met = centre + clamp(dot(at, u) / dot(u, u), -1.0, 1.0) * u + clamp(dot(at, v) / dot(v, v), -1.0, 1.0) * v;
  found.distance = length(met);
  found.direction = met / max(found.distance, LEAST_DIVISOR);
  found.n = n;
  found.sigma = min(width, 0.4);
  return found;
}

#endif
