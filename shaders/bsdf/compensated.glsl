// compensated.glsl: the half-vector with the rounding errors of its sums and products carried along.
// Frame    any: n a normal; wo, wi unit to float32's rounding and away from the surface. The answer is for their exactly
//          normalised selves, so nothing is lost to |wi| and |wo| differing in the last place.
// alpha    none. eta as in half_vector.glsl.
// Returns  reflectionFacetCompensated, transmissionFacetCompensated: the same Facet as half_vector.glsl gives, its tilts
//          and cosines to a few float32 roundings whatever cancels: a mirror at grazing incidence, straight through an
//          index near 1, the critical angle, alpha 1e-6.
// Source   [Dekker71] (two-sum, two-product by splitting), [OgitaRumpOishi05] (dot products in twice the precision).
// Limits   needs sums that the compiler does not rearrange: `precise` says so in desktop GLSL; GLSL ES 3.00 has no such word,
//          and a driver that fuses or reorders there gives the digits back. fma is not used: it may be unfused.
#ifndef GG_BSDF_COMPENSATED_GLSL
#define GG_BSDF_COMPENSATED_GLSL

#include "bsdf/half_vector.glsl"

#if defined(__cplusplus)
#define GG_PRECISE
// Dekker's splitter is 2^ceil(p / 2) + 1 for a p-bit significand.
const float BSDF_SPLITTER = sizeof(float) == 8 ? 134217729.0 : 4097.0;
#elif defined(GL_ES)
#define GG_PRECISE
const float BSDF_SPLITTER = 4097.0;
#else
#define GG_PRECISE precise
const float BSDF_SPLITTER = 4097.0;
#endif

// The unevaluated sum of a rounded value and what rounding it lost.
struct Exact {
  float hi;
  float lo;
};

struct ExactVec {
  Exact x;
  Exact y;
  Exact z;
};

// a + b without error.
Exact exactSum(float a, float b) {
  GG_PRECISE float s = a + b;
  GG_PRECISE float fromB = s - a;
  GG_PRECISE float fromA = s - fromB;
  GG_PRECISE float lost = (a - fromA) + (b - fromB);
  Exact r;
  r.hi = s;
  r.lo = lost;
  return r;
}

// The upper half of a's significand; a minus it fits the lower half.
float exactUpper(float a) {
  GG_PRECISE float scaled = BSDF_SPLITTER * a;
  GG_PRECISE float rest = scaled - a;
  GG_PRECISE float upper = scaled - rest;
  return upper;
}

// a b without error: the four products of halves are exact.
Exact exactProduct(float a, float b) {
  GG_PRECISE float p = a * b;
  float aUpper = exactUpper(a);
  float bUpper = exactUpper(b);
  GG_PRECISE float aLower = a - aUpper;
  GG_PRECISE float bLower = b - bUpper;
  GG_PRECISE float lost = ((aUpper * bUpper - p) + aUpper * bLower + aLower * bUpper) + aLower * bLower;
  Exact r;
  r.hi = p;
  r.lo = lost;
  return r;
}

// a + b to twice the precision of the larger one.
Exact exactAdd(Exact a, Exact b) {
  Exact s = exactSum(a.hi, b.hi);
  GG_PRECISE float lo = s.lo + (a.lo + b.lo);
  return exactSum(s.hi, lo);
}

Exact exactDot(vec3 a, vec3 b) {
  return exactAdd(exactAdd(exactProduct(a.x, b.x), exactProduct(a.y, b.y)), exactProduct(a.z, b.z));
}

// A two-part number times a plain one.
Exact exactScale(Exact a, float b) {
  Exact p = exactProduct(a.hi, b);
  GG_PRECISE float lo = p.lo + a.lo * b;
  return exactSum(p.hi, lo);
}

Exact exactDotVec(ExactVec a, vec3 b) {
  return exactAdd(exactAdd(exactScale(a.x, b.x), exactScale(a.y, b.y)), exactScale(a.z, b.z));
}

// |v|² / 2 - 1 / 2: what a nearly unit v has too much of its own length, to first order.
float exactExcess(vec3 v) {
  Exact minusOne;
  minusOne.hi = -1.0;
  minusOne.lo = 0.0;
  return 0.5 * exactAdd(exactDot(v, v), minusOne).hi;
}

// a / |a| + eta b / |b| of one component, with the excess lengths of a and b known.
Exact exactHalf(float a, float b, float eta, float excessA, float excessB) {
  Exact bent = exactProduct(eta, b);
  Exact s = exactSum(a, bent.hi);
  GG_PRECISE float lo = s.lo + (bent.lo - (excessA * a + excessB * bent.hi));
  return exactSum(s.hi, lo);
}

ExactVec exactHalfVector(vec3 wo, vec3 wi, float eta) {
  float excessO = exactExcess(wo);
  float excessI = exactExcess(wi);
  ExactVec h;
  h.x = exactHalf(wo.x, wi.x, eta, excessO, excessI);
  h.y = exactHalf(wo.y, wi.y, eta, excessO, excessI);
  h.z = exactHalf(wo.z, wi.z, eta, excessO, excessI);
  return h;
}

// a c - b d, rounded once.
float exactDifference(Exact a, float c, Exact b, float d) {
  return exactAdd(exactScale(a, c), exactScale(b, -d)).hi;
}

Tilt exactTilt(ExactVec h, vec3 n, float hDotN) {
  float x = exactDifference(h.y, n.z, h.z, n.y);
  float y = exactDifference(h.z, n.x, h.x, n.z);
  float z = exactDifference(h.x, n.y, h.y, n.x);
  Tilt t;
  t.p = x * x + y * y + z * z;
  t.z = abs(hDotN);
  return t;
}

// Of a direction: only its cosine can cancel where it matters, at grazing, where p is near 1.
Tilt exactTiltOf(vec3 w, vec3 n, float wDotN) {
  Tilt t = tiltAbout(w, n);
  t.z = abs(wDotN);
  return t;
}

Facet reflectionFacetCompensated(vec3 wi, vec3 wo, vec3 n, float eta) {
  ExactVec h = exactHalfVector(wo, wi, 1.0);
  float cosI = exactDot(wi, n).hi;
  float cosO = exactDot(wo, n).hi;
  vec3 rounded = vec3(h.x.hi, h.y.hi, h.z.hi);
  vec3 rest = vec3(h.x.lo, h.y.lo, h.z.lo);
  Exact s = exactDot(rounded, rounded);
  s.lo += 2.0 * dot(rounded, rest);
  Facet f;
  f.wi = exactTiltOf(wi, n, cosI);
  f.wo = exactTiltOf(wo, n, cosO);
  f.h = exactTilt(h, n, exactDotVec(h, n).hi);
  f.s = s.hi;
  f.woDotM = min(0.5 * sqrt(f.s), 1.0);
  f.wiDotM = f.woDotM;
  // g² = eta² - 1 + c², c² = s / 4, in twice the precision: at the critical angle all three nearly cancel.
  Exact minusOne;
  minusOne.hi = -1.0;
  minusOne.lo = 0.0;
  Exact c2;
  c2.hi = 0.25 * s.hi;
  c2.lo = 0.25 * s.lo;
  f.g = sqrt(max(exactAdd(exactAdd(exactProduct(eta, eta), minusOne), c2).hi, 0.0));
  f.exists = ((cosI > 0.0 && cosO > 0.0) || (cosI < 0.0 && cosO < 0.0)) && f.h.z > 0.0;
  return f;
}

Facet transmissionFacetCompensated(vec3 wi, vec3 wo, vec3 n, float eta) {
  ExactVec h = exactHalfVector(wo, wi, eta);
  float cosI = exactDot(wi, n).hi;
  float cosO = exactDot(wo, n).hi;
  float hDotN = exactDotVec(h, n).hi;
  float side = hDotN * cosO < 0.0 ? -1.0 : 1.0;
  float hDotI = side * exactDotVec(h, wi).hi;
  float hDotO = side * exactDotVec(h, wo).hi;
  vec3 rounded = vec3(h.x.hi, h.y.hi, h.z.hi);
  Facet f;
  f.wi = exactTiltOf(wi, n, cosI);
  f.wo = exactTiltOf(wo, n, cosO);
  f.h = exactTilt(h, n, hDotN);
  f.s = dot(rounded, rounded);
  bool possible = ((cosI > 0.0 && cosO < 0.0) || (cosI < 0.0 && cosO > 0.0)) && eta > 0.0 && eta != 1.0;
  f.exists = possible && f.h.z > 0.0 && hDotI < 0.0 && hDotO > 0.0;
  float scale = f.exists ? inversesqrt(f.s) : 0.0;
  f.wiDotM = min(abs(hDotI) * scale, 1.0);
  f.woDotM = min(abs(hDotO) * scale, 1.0);
  f.g = eta * f.wiDotM;
  return f;
}

#endif
