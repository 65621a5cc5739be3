// multiple_scattering.glsl: giving back the light that single scattering loses between the facets.
// Frame    none: energies and cosines. cosO = |wo . n|.
// alpha    slope width in [0, 1] of GGX; other distributions behave alike.
// Returns  multipleScatteringF: f in 1/sr, reciprocal, its cosine integral is 1 - eO. multipleFresnel(Rgb): the tint
//          of that lobe, in [0, 1]. multipleScatteringSplit: total energies R*, T* with R* + T* = 1. eO, eI:
//          directional albedo of the lossless surface seen from wo, wi; eAvg: its cosine-weighted mean 2 ∫ e c dc;
//          r1, t1: single-scattering energies R1(wo), T1(wo), r1 + t1 <= 1. All from tables, all in [0, 1].
// Source   [KullaConty17] (metals); the split is fitted to a Smith random walk [Heitz16] written for tests/bsdf.
// Limits   energies, not shapes: the walk's own lobe is not diffuse. Against the walk, in units of the incoming
//          light: metals of reflectance .5 to .9 within 0.012 up to alpha .5, 0.033 at alpha 1; entering (eta > 1)
//          within 0.032; leaving within 0.034 for eta 1 / 1.5, 0.021 rms and 0.14 at worst for 1 / 1.1 to 1 / 2.4
//          (alpha .1 to 1).
#ifndef GG_BSDF_MULTIPLE_SCATTERING_GLSL
#define GG_BSDF_MULTIPLE_SCATTERING_GLSL

#include "bsdf/constants.glsl"

// A smooth surface has eAvg = 1 and nothing to give back.
float multipleScatteringF(float eI, float eO, float eAvg) {
  float lost = 1.0 - eAvg;
  return lost > 0.0 ? (1.0 - eI) * (1.0 - eO) / (BSDF_PI * lost) : 0.0;
}

// Every bounce tints by the mean reflectance f, and a share eAvg of what has bounced leaves, so of the light that
// single scattering loses f² eAvg sum (f (1 - eAvg))^k comes out. (The first f is the bounce that was lost.)
float multipleFresnel(float f, float eAvg) {
  float left = 1.0 - f * (1.0 - eAvg);
  return left > 0.0 ? f * f * eAvg / left : 0.0;
}

vec3 multipleFresnelRgb(vec3 f, float eAvg) {
  return vec3(multipleFresnel(f.x, eAvg), multipleFresnel(f.y, eAvg), multipleFresnel(f.z, eAvg));
}

struct SplitEnergy {
  float reflected;
  float transmitted;
};

// Light lost on the way into the denser medium has met facets that mostly let it through, and nearly all of it ends up
// inside. Light lost on the way out mostly meets total reflection; what gets out does so through the escape cone, whose
// share of directions falls as eta², and the more readily the steeper it came.
SplitEnergy multipleScatteringSplit(float r1, float t1, float cosO, float alpha, float eta) {
  float lost = max(1.0 - r1 - t1, 0.0);
  float outward = eta < 1.0 ? 1.0 - eta * eta * cosO * (0.35 + 0.55 * min(alpha, 1.0)) : 0.0;
  SplitEnergy e;
  e.reflected = r1 + lost * outward;
  e.transmitted = 1.0 - e.reflected;
  return e;
}

#endif
