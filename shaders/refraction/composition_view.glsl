// composition_view.glsl: a rough exit as one lobe of the entry sees it: where its tables are read.
// Frame    any. InnerLobe.direction travels inside, unit; n points outward where it leaves. Either side may be the denser one.
// alpha    slope width of the exit, [0, 1]; sigma: radians. eta = n_outside / n_inside at the exit (> 0).
// Returns  wideningGgx, wideningBeckmann: the rule's constants. exitTurn, sphereTurn: ExitSurface.turn of a face of known
//          curvature. seeExit: widths in [0, 1]. leavingNextAlpha: of the face that reflected light meets next, in [0, 1].
// Source   [Walter07] for the model; the constants are fits to brute force (tests/composition).
// Limits   those of composition.glsl. About 20 multiply-adds and 3 square roots per inner lobe.
#ifndef GG_REFRACTION_COMPOSITION_VIEW_GLSL
#define GG_REFRACTION_COMPOSITION_VIEW_GLSL

#include "bsdf/constants.glsl"

// Where a ray leaves the solid.
struct ExitSurface {
  vec3 n;      // outward: dot(n, direction) > 0
  float alpha; // slope width
  float eta;   // n_outside / n_inside: below 1 for glass in air
  vec2 turn;   // n's turn per radian of the inner direction, in the plane of incidence and across it; 0 for a flat face
};

// One Gaussian of the light inside.
struct InnerLobe {
  vec3 direction;
  float sigma;
  float weight; // energy included
};

// By how much a spread of rays widens the facets that an exit's tables are read at: alpha² + (k sigma)².
struct Widening {
  float shape;      // for directions and widths. The tables' own sigma per alpha and radian of facet tilt is about 1 / shape
  float shapeRays;  // the same where the face is smooth and all of the width the ray's: then only the tables' core is read
  float energyCore; // for the energy let through: of the entry's first lobe, of its second
  float energyTail;
};

// The exit as one inner lobe sees it.
struct ExitView {
  float cosTheta;    // on the inner side; not above 0: the lobe does not meet this face
  float alphaShape;  // where the lobe is read
  float alphaEnergy; // where what passes is read
  float own;   // the share of alphaShape² that is the face's own
  float swing; // turn of the angle of incidence per radian of the inner direction, not 0
};

// Fitted to brute force for tables of that many lobes.
Widening wideningGgx(int lobes) {
  Widening k;
  k.shape = lobes > 1 ? 0.7 : 0.6;
  k.shapeRays = lobes > 1 ? 0.91 : 0.6;
  k.energyCore = lobes > 1 ? 1.05 : 0.95;
  k.energyTail = 0.85;
  return k;
}

// Beckmann's Gaussian slopes are narrower than GGX's of the same alpha: the same spread of rays is worth more of it.
Widening wideningBeckmann(int lobes) {
  Widening k;
  k.shape = lobes > 1 ? 1.0 : 1.2;
  k.shapeRays = lobes > 1 ? 1.3 : 1.2;
  k.energyCore = lobes > 1 ? 1.3 : 1.5;
  k.energyTail = 1.6;
  return k;
}

// A curved exit, cosTheta and pathLength of the ray that reaches it: normal curvatures (1/m, positive where the solid is convex)
// in the plane of incidence and across it. Towards grazing rays the spot on the surface grows without end, the turn stops at
// four times the sphere's 2: there the face is no longer one surface of one curvature.
vec2 exitTurn(float cosTheta, float pathLength, vec2 curvature) {
  vec2 turn = vec2(pathLength * curvature.x / max(cosTheta, LEAST_LENGTH), pathLength * curvature.y);
  return clamp(turn, -8.0, 8.0);
}

// A solid sphere, where the path is 2 R cosTheta.
vec2 sphereTurn(float cosTheta) { return vec2(2.0, 2.0 * cosTheta); }

// A focus on the exit itself: rays that meet there all have one angle of incidence, and all that is asked of it is divided by how
// fast that changes. This much off the focus the directions outside change by a twentieth of the spread.
const float LEAST_SWING = 0.05;

// The exit cannot tell a spread of rays from a spread of its facets: widened by the ray, its own table holds the edge of total
// reflection, the bent mean and the width at which refraction saturates.
ExitView seeExit(InnerLobe inner, bool core, ExitSurface s, Widening k) {
  ExitView v;
  v.cosTheta = min(dot(inner.direction, s.n), 1.0);
  v.swing = 1.0 - s.turn.x;
  v.swing = v.swing < 0.0 ? min(v.swing, -LEAST_SWING) : max(v.swing, LEAST_SWING);
  float alpha2 = s.alpha * s.alpha;
  float spread = inner.sigma * v.swing; // of the angle of incidence
  float spread2 = spread * spread;
  float rays2 = k.shape * k.shape * spread2;
  float rays = rays2 > 0.0 ? rays2 / (alpha2 + rays2) : 0.0;
  float shape = mix(k.shape, k.shapeRays, rays);
  float shape2 = alpha2 + shape * shape * spread2;
  float energy = core ? k.energyCore : k.energyTail;
  v.alphaShape = min(sqrt(shape2), 1.0);
  v.alphaEnergy = min(sqrt(alpha2 + energy * energy * spread2), 1.0);
  v.own = shape2 > 0.0 ? alpha2 / shape2 : 1.0;
  return v;
}

// What the exit reflects inside meets the next face as wide as the ray was, and by twice the exit's own tilt wider. What is far out
// is beyond the critical angle again: of the light that the next face would pass, this share gets there.
const float LEAVES_NEXT = 0.65;
float leavingNextAlpha(float innerSigma, float alpha, float nextAlpha) {
  float spread = 1.3 * innerSigma;
  return min(sqrt(nextAlpha * nextAlpha + 3.0 * alpha * alpha + spread * spread), 1.0);
}

#endif
