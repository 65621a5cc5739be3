// form_factor.glsl: the share of a cosine lobe that a sphere or a rectangle occludes: form factors, cut by the horizon.
// Frame    any, the receiver's point at the origin; n unit, lengths metres.
// alpha    none.
// Returns  sphereFormFactor, rectangleFormFactor: in [0, 1], with weight cos / pi. capFormFactor: of a spherical cap of sin²(rho) =
//          sin2, its axis at that cosine to n. rectangleVector: the same as a vector, whose product with any n is the form factor
//          of what does not cross its horizon; it points to the middle of what is met.
// Source   [Snyder96], a cap across the horizon; [Lambert60], an edge's share; [HillHeitz17], a polygon across the horizon as the
//          cap of the same vector.
// Limits   sphere exact, the point outside it. Rectangle exact above the horizon, else .01 rms, .06 at worst (tests/neighbours).
//          On the sphere or in the plane of the rectangle: finite, in [0, 1].
#ifndef GG_NEIGHBOURS_FORM_FACTOR_GLSL
#define GG_NEIGHBOURS_FORM_FACTOR_GLSL

#include "bsdf/constants.glsl"

float capFormFactor(float cosTheta, float sin2) {
  float within = min(sin2, 0.999); // the cap of a half space: the receiver lies on what it sees
  float c = clamp(cosTheta, -1.0, 1.0);
  if (c * c >= within) return within * max(c, 0.0);
  float sinTheta = sqrt(1.0 - c * c);
  float cot = sqrt(1.0 / max(within, LEAST_LENGTH2) - 1.0);
  float y = clamp(-cot * c / sinTheta, -1.0, 1.0);
  float chord = sinTheta * sqrt(1.0 - y * y);
  return clamp(((c * acos(y) - cot * chord) * within + atan(chord / cot)) / 3.14159265, 0.0, 1.0);
}

float sphereFormFactor(vec3 centre, float radius, vec3 n) {
  float range2 = dot(centre, centre);
  if (!(range2 > 0.0)) return 0.0;
  return capFormFactor(dot(centre, n) * inversesqrt(range2), radius * radius / range2);
}

// Of the edge between two directions: the angle between them, along the normal of their plane.
vec3 edgeVector(vec3 a, vec3 b) {
  vec3 across = cross(a, b);
  float sine = length(across);
  // Below a ten-millionth of a radian atan(x) / x is 1 in float32.
  return sine > 1e-7 ? across * (atan(sine, dot(a, b)) / sine) : across;
}

vec3 rectangleVector(vec3 centre, vec3 u, vec3 v) {
  vec3 a = normalize(centre - u - v);
  vec3 b = normalize(centre + u - v);
  vec3 c = normalize(centre + u + v);
  vec3 d = normalize(centre - u + v);
  vec3 sum = edgeVector(a, b) + edgeVector(b, c) + edgeVector(c, d) + edgeVector(d, a);
  // Towards the rectangle, on whichever side of it the receiver is.
  float turned = dot(cross(u, v), centre) < 0.0 ? -1.0 : 1.0;
  return sum * (turned / 6.2831853);
}

float rectangleFormFactor(vec3 centre, vec3 u, vec3 v, vec3 n) {
  vec3 f = rectangleVector(centre, u, v);
  float size = length(f);
  return size > 0.0 ? capFormFactor(dot(f, n) / size, size) : 0.0;
}

#endif
