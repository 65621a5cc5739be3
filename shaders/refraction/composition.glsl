// composition.glsl: the lobe of two rough interfaces, composed from the lobes of one: effective roughness.
// Frame    any. Directions as light's path is followed from the viewer: InnerLobe.direction travels inside, n points outward
//          where it leaves, ComposedLobe.direction travels outside. All unit. Either side may be the denser one.
// alpha    slope width of the exit, [0, 1]; sigma: radians. eta = n_outside / n_inside at the exit (> 0).
// Returns  composeLobe: one lobe outside; weight 0 where the lobe does not meet the face. mergeLobes: two lobes as one.
//          composedPair, mergePairs: core and rest of an exit's two lobes; of the entry's two.
// Source   variances add through Snell's Jacobian where lobes are narrow [Walter07]; beyond that a fit (tests/composition).
// Limits   single scattering, sigma is the geometric mean of the two axes, isotropic alpha, no twist of a curved exit.
//          Worst for rough entry and nearly smooth exit within 5 degrees of the critical angle, where the truth is a lobe cut off
//          at the horizon. Per lobe 70 multiply-adds, 1 atan, 2 sin, 2 cos, 4 square roots.
#ifndef GG_REFRACTION_COMPOSITION_GLSL
#define GG_REFRACTION_COMPOSITION_GLSL

#include "bsdf/constants.glsl"
#include "refraction/composition_view.glsl"

// One Gaussian of the light outside. At a distance D beyond the exit, after a path d inside, the light that is seen has the
// variance D² sigma² + 2 D d inner carried + d² inner² (metres² per axis).
struct ComposedLobe {
  vec3 direction;
  float sigma;
  float weight;  // energy included
  float inner;   // sigma of the ray inside
  float carried; // radians outside per sigma inside: the part of sigma that goes with it; below 0 where a curved exit crosses rays
};

// Below this distance of eta from 1 a face turns rays by less than float32 knows a facet's tilt from two directions (1e-7 of
// rounding over 1e-4 of bending): it is not there.
const float INDEX_MATCHED = 1e-4;

// Rules for where derivatives grow without end. A lobe is never wider in plane than total reflection lets it be (the lobes'
// saturation, 0.3 rad); a facet is never seen closer to grazing than 0.2, where its lobe's far side is cut off.
const float COMPOSED_WIDEST = 0.3;
const float FACET_LEAST_COS = 0.2;
// Of the facets' mean tilt that the widened table has, the part that is the rays' and turns with them; the rest is there without
// rays, as facets that lean towards the ray are seen more.
const float GIVEN_BACK = 0.7;

// (angle, sigma, weight): a lobe of the exit's table at (view.cosTheta, view.alphaShape, s.eta), angle from n towards the side
// that the ray travels to. energy: what the exit lets through at (view.cosTheta, view.alphaEnergy, s.eta).
//
// With x1 the ray's deviation and x2 the facet's, u = x1 - x2 is all that the exit sees: out = phi(theta + u) + x2, where given
// u, x1 takes the share 1 - own and x2 -own. On a curved face x1 also turns the frame that phi counts from.
ComposedLobe composeLobe(InnerLobe inner, ExitView view, ExitSurface s, float angle, float sigma, float weight,
                       float energy) {
  ComposedLobe lobe;
  lobe.direction = inner.direction;
  lobe.sigma = inner.sigma;
  lobe.inner = inner.sigma;
  lobe.carried = inner.sigma;
  lobe.weight = inner.weight * weight * energy;
  if (!(view.cosTheta > 0.0)) lobe.weight = 0.0;
  float ratio = 1.0 / s.eta; // Snell: sin outside = ratio sin inside
  if (!(view.cosTheta > 0.0) || abs(ratio - 1.0) < INDEX_MATCHED) return lobe;

  // In the plane of incidence: x along the face, y along n.
  vec3 along = inner.direction - view.cosTheta * s.n;
  float sinTheta = length(along);
  vec3 t = along / max(sinTheta, LEAST_DIVISOR); // straight through: the zero vector, and the tables' angle is 0
  vec2 d = vec2(sinTheta, view.cosTheta);
  vec2 l = vec2(sin(angle), cos(angle));
  vec2 h = (ratio * d - l) * (ratio < 1.0 ? -1.0 : 1.0); // the mean facet, on n's side
  float bend = max(length(h), 0.5 * INDEX_MATCHED);      // |ratio ci - co|
  float ci = dot(d, h) / bend;
  float co = max(dot(l, h) / bend, FACET_LEAST_COS);

  float rays = 1.0 - view.own;
  float turned = clamp(angle - GIVEN_BACK * rays / view.swing * atan(h.x, abs(h.y)), -0.5 * BSDF_PI, 0.5 * BSDF_PI);
  lobe.direction = normalize(sin(turned) * t + cos(turned) * s.n);

  float kept = view.own - rays * (1.0 - view.swing) / view.swing;
  float seen = sigma * inversesqrt(co) * (ratio * ci - kept * co) / bend;
  float across = ratio + (co - ratio * ci) * s.turn.y;
  float sigma2 = inner.sigma * inner.sigma;
  float inPlane = min(seen * seen + view.own * sigma2, COMPOSED_WIDEST * COMPOSED_WIDEST);
  float outOfPlane = view.own * sigma * sigma * co + across * across * sigma2;
  lobe.sigma = sqrt(sqrt(inPlane * outOfPlane));
  float carriedInPlane = (view.swing < 0.0 ? -sqrt(rays) : sqrt(rays)) * seen + view.own * inner.sigma;
  lobe.carried = clamp(0.5 * (carriedInPlane + across * inner.sigma), -lobe.sigma, lobe.sigma);
  return lobe;
}

// Two lobes as one of the same energy, mean and variance (per axis half of the squared distance between them).
ComposedLobe mergeLobes(ComposedLobe a, ComposedLobe b) {
  float weight = a.weight + b.weight;
  float share = weight > 0.0 ? b.weight / weight : 0.0;
  vec3 apart = b.direction - a.direction;
  vec3 mean = a.direction + share * apart;
  float inner2 = mix(a.inner * a.inner, b.inner * b.inner, share);
  float both = mix(a.inner * a.carried, b.inner * b.carried, share);
  ComposedLobe lobe;
  lobe.weight = weight;
  // Opposite lobes of equal weight have no mean: the first's direction then.
  lobe.direction = dot(mean, mean) > 1e-6 ? normalize(mean) : a.direction;
  lobe.sigma = sqrt(mix(a.sigma * a.sigma, b.sigma * b.sigma, share) + 0.5 * share * (1.0 - share) * dot(apart, apart));
  lobe.inner = sqrt(inner2);
  lobe.carried = lobe.inner > 0.0 ? both / lobe.inner : 0.0;
  return lobe;
}

// What one lobe of the entry becomes, or the whole lobe.
struct ComposedPair {
  ComposedLobe core;
  ComposedLobe rest;
};

// The two lobes of an exit's table. Its tail is that of facets: rays have theirs in a lobe of their own. So much of it as stands
// for a spread of rays goes to the core.
ComposedPair composedPair(ComposedLobe core, ComposedLobe tail, ExitView view) {
  float moved = (1.0 - view.own) * tail.weight;
  ComposedPair pair;
  pair.core = core;
  pair.rest = tail;
  pair.core.weight = core.weight + moved;
  pair.rest.weight = tail.weight - moved;
  return pair;
}

// Of the entry's core and tail: core through core is kept, the other three are one.
ComposedPair mergePairs(ComposedPair core, ComposedPair tail) {
  ComposedPair pair;
  pair.core = core.core;
  pair.rest = mergeLobes(mergeLobes(core.rest, tail.core), tail.rest);
  return pair;
}

#endif
