// compensated.glsl: half-vectors in twice the precision, for the places where wi and wo nearly cancel.
// Frame    any: as reflectionFacet and transmissionFacet (half_vector.glsl), but wi, wo and n need not be exactly unit:
//          the result is for their normalised selves. Zero vectors give exists = false.
// alpha    none. eta = n_far / n_known, far = wi's side, known = wo's side; 0 stands for a metal.
// Returns  preciseReflectionFacet, preciseTransmissionFacet: a Facet whose every number is right to a few ulp.
// Source   [Walter07] eq. 13, 16; the arithmetic is twin.glsl's and twin_vector.glsl's.
// Limits   about twelve times the arithmetic of the plain facet (numbers in shaders/README.md). Worth it offline, in
//          proofs, and for mirrors at grazing angles; a picture does not show the difference. See twin.glsl for ES
//          3.00.
#ifndef GG_BSDF_COMPENSATED_GLSL
#define GG_BSDF_COMPENSATED_GLSL

#include "bsdf/half_vector.glsl"
#include "bsdf/twin_vector.glsl"

// A direction against n: p = |v x n|², z = v . n with its sign.
struct SignedTilt {
  float p;
  Twin z;
};

SignedTilt preciseTilt(Twin3 v, Twin3 n) {
  vec3 across = twinCross(v, n).hi;
  SignedTilt t;
  t.p = dot(across, across);
  t.z = twinDot(v, n);
  return t;
}

Tilt unsignedTilt(SignedTilt signedTilt) {
  Tilt t;
  t.p = signedTilt.p;
  t.z = abs(signedTilt.z.hi);
  return t;
}

// The half-vector against n, on the scale of z = 1, so that its tan² is p, rounded once: the exponentials of Beckmann
// and Phong multiply each rounding by up to 70 in their tails. z is 0 for a facet on the horizon.
Tilt preciseSlope(Twin3 h, Twin3 n, Twin z) {
  Twin3 across = twinCross(h, n);
  Tilt t;
  t.p = 0.0;
  t.z = 0.0;
  if (z.hi != 0.0) {
    t.p = twinOverSquare(twinDot(across, across), z);
    t.z = 1.0;
  }
  return t;
}

bool usable(vec3 v) { return dot(v, v) > 0.0; }

Facet noFacet() {
  Facet f;
  f.wi.p = 0.0;
  f.wi.z = 0.0;
  f.wo = f.wi;
  f.h = f.wi;
  f.s = 0.0;
  f.wiDotM = 0.0;
  f.woDotM = 0.0;
  f.g = 0.0;
  f.exists = false;
  return f;
}

Facet preciseReflectionFacet(vec3 wi, vec3 wo, vec3 n, float eta) {
  if (!(usable(wi) && usable(wo) && usable(n))) return noFacet();
  Twin3 i = twinNormalize(wi);
  Twin3 o = twinNormalize(wo);
  Twin3 up = twinNormalize(n);
  Twin3 h = twinAdd(i, o);
  SignedTilt tiltI = preciseTilt(i, up);
  SignedTilt tiltO = preciseTilt(o, up);
  Twin s = twinDot(h, h);
  Facet f;
  f.wi = unsignedTilt(tiltI);
  f.wo = unsignedTilt(tiltO);
  f.h = preciseSlope(h, up, twinDot(h, up));
  f.s = s.hi;
  f.woDotM = min(0.5 * sqrt(s.hi), 1.0);
  f.wiDotM = f.woDotM;
  // g² = eta² - 1 + cos², summed at twice the precision: at the critical angle it is what is left of two equal numbers.
  Twin3 terms = twinProduct(vec3(eta, 0.0, 0.0), vec3(eta, 0.0, 0.0));
  terms.hi = vec3(terms.hi.x, -1.0, 0.25 * s.hi);
  terms.lo = vec3(terms.lo.x, 0.0, 0.25 * s.lo);
  f.g = sqrt(max(twinTotal(terms).hi, 0.0));
  f.exists = ((tiltI.z.hi > 0.0 && tiltO.z.hi > 0.0) || (tiltI.z.hi < 0.0 && tiltO.z.hi < 0.0)) && f.h.z > 0.0;
  return f;
}

Facet preciseTransmissionFacet(vec3 wi, vec3 wo, vec3 n, float eta) {
  if (!(usable(wi) && usable(wo) && usable(n) && eta > 0.0 && eta != 1.0)) return noFacet();
  Twin3 i = twinNormalize(wi);
  Twin3 o = twinNormalize(wo);
  Twin3 up = twinNormalize(n);
  Twin3 factor;
  factor.hi = vec3(eta);
  factor.lo = vec3(0.0);
  Twin3 h = twinAdd(o, twinMultiply(i, factor));
  SignedTilt tiltI = preciseTilt(i, up);
  SignedTilt tiltO = preciseTilt(o, up);
  Twin hDotN = twinDot(h, up);
  float side = (hDotN.hi < 0.0) == (tiltO.z.hi < 0.0) ? 1.0 : -1.0;
  float hDotI = side * twinDot(h, i).hi;
  float hDotO = side * twinDot(h, o).hi;
  bool opposite = (tiltI.z.hi > 0.0 && tiltO.z.hi < 0.0) || (tiltI.z.hi < 0.0 && tiltO.z.hi > 0.0);
  Facet f;
  f.wi = unsignedTilt(tiltI);
  f.wo = unsignedTilt(tiltO);
  f.h = preciseSlope(h, up, hDotN);
  f.s = twinDot(h, h).hi;
  f.exists = opposite && f.h.z > 0.0 && hDotI < 0.0 && hDotO > 0.0;
  float scale = f.exists ? inversesqrt(f.s) : 0.0;
  f.wiDotM = min(abs(hDotI) * scale, 1.0);
  f.woDotM = min(abs(hDotO) * scale, 1.0);
  f.g = eta * f.wiDotM;
  return f;
}

#endif
