// twin.glsl: numbers of twice the precision, as unevaluated sums hi + lo of two of the machine's own.
// Frame    none; component by component.
// alpha    none.
// Returns  each operation: the result to about 2^-46 relative to its operands (float32), hi rounded to nearest, |lo|
//          <= ulp / 2.
// Source   [Dekker71] (split, product), [Knuth97] 4.2.2 theorem B (sum).
// Limits   right only where every operation is rounded on its own: PRECISE asks for that in desktop GLSL, C++ needs
//          contraction off (-ffp-contract=off); ES 3.00 has no such word, and a compiler there may undo the work. fma
//          is of no use: it is not fused on every device. Overflows above 1e34. Define BSDF_DOUBLE where float is
//          double.
#ifndef GG_BSDF_TWIN_GLSL
#define GG_BSDF_TWIN_GLSL

#if defined(__cplusplus) || defined(GL_ES)
#define PRECISE
#else
#define PRECISE precise
#endif

// 2^ceil(digits / 2) + 1: times this, a number falls apart into two halves of its digits, whose products are exact.
#ifdef BSDF_DOUBLE
const float BSDF_SPLITTER = 134217729.0;
#else
const float BSDF_SPLITTER = 4097.0;
#endif

struct Twin3 {
  vec3 hi;
  vec3 lo;
};

struct Twin {
  float hi;
  float lo;
};

// hi + lo with hi the rounded sum, for |hi| >= |lo|.
Twin3 twinRenormalize(vec3 hi, vec3 lo) {
  PRECISE vec3 sum = hi + lo;
  PRECISE vec3 rest = lo - (sum - hi);
  Twin3 t;
  t.hi = sum;
  t.lo = rest;
  return t;
}

// a + b without error.
Twin3 twinSum(vec3 a, vec3 b) {
  PRECISE vec3 sum = a + b;
  PRECISE vec3 bPart = sum - a;
  PRECISE vec3 aPart = sum - bPart;
  PRECISE vec3 rest = (a - aPart) + (b - bPart);
  Twin3 t;
  t.hi = sum;
  t.lo = rest;
  return t;
}

// a b without error.
Twin3 twinProduct(vec3 a, vec3 b) {
  PRECISE vec3 product = a * b;
  PRECISE vec3 aBig = BSDF_SPLITTER * a;
  PRECISE vec3 bBig = BSDF_SPLITTER * b;
  PRECISE vec3 aHigh = aBig - (aBig - a);
  PRECISE vec3 bHigh = bBig - (bBig - b);
  PRECISE vec3 aLow = a - aHigh;
  PRECISE vec3 bLow = b - bHigh;
  PRECISE vec3 rest = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
  Twin3 t;
  t.hi = product;
  t.lo = rest;
  return t;
}

Twin3 twinAdd(Twin3 a, Twin3 b) {
  Twin3 sum = twinSum(a.hi, b.hi);
  PRECISE vec3 low = sum.lo + (a.lo + b.lo);
  return twinRenormalize(sum.hi, low);
}

Twin3 twinMultiply(Twin3 a, Twin3 b) {
  Twin3 product = twinProduct(a.hi, b.hi);
  PRECISE vec3 low = product.lo + (a.hi * b.lo + a.lo * b.hi);
  return twinRenormalize(product.hi, low);
}

Twin3 twinNegate(Twin3 a) {
  a.hi = -a.hi;
  a.lo = -a.lo;
  return a;
}

Twin twinSum(float a, float b) {
  PRECISE float sum = a + b;
  PRECISE float bPart = sum - a;
  PRECISE float aPart = sum - bPart;
  PRECISE float rest = (a - aPart) + (b - bPart);
  Twin t;
  t.hi = sum;
  t.lo = rest;
  return t;
}

#endif
