// twin_vector.glsl: dot and cross products, and unit vectors, in twice the precision.
// Frame    any, one for all vectors of a call.
// alpha    none.
// Returns  twinDot, twinTotal, twinCross, twinNormalize: twins, right to about 2^-46 of their operands. twinOverSquare:
//          p / z², rounded once.
// Source   [Dekker71], [Knuth97]; the arithmetic is twin.glsl's.
// Limits   twinNormalize takes |v| from 1e-15 to 1e15 in float32, and not the zero vector; twinOverSquare not z = 0.
#ifndef GG_BSDF_TWIN_VECTOR_GLSL
#define GG_BSDF_TWIN_VECTOR_GLSL

#include "bsdf/twin.glsl"

// The sum of the three components.
Twin twinTotal(Twin3 a) {
  Twin xy = twinSum(a.hi.x, a.hi.y);
  Twin xyz = twinSum(xy.hi, a.hi.z);
  PRECISE float low = (xy.lo + xyz.lo) + (a.lo.x + a.lo.y + a.lo.z);
  return twinSum(xyz.hi, low);
}

Twin twinDot(Twin3 a, Twin3 b) { return twinTotal(twinMultiply(a, b)); }

Twin3 twinTurn(Twin3 a) {
  Twin3 t;
  t.hi = vec3(a.hi.y, a.hi.z, a.hi.x);
  t.lo = vec3(a.lo.y, a.lo.z, a.lo.x);
  return t;
}

// a x b: the products cancel at twice the precision.
Twin3 twinCross(Twin3 a, Twin3 b) {
  Twin3 product = twinMultiply(a, twinTurn(b));
  Twin3 other = twinMultiply(twinTurn(a), b);
  return twinTurn(twinAdd(product, twinNegate(other)));
}

// p / z², rounded once: the plain quotient and what the exact product says that it lacks. z is not 0.
float twinOverSquare(Twin p, Twin z) {
  float rough = p.hi / (z.hi * z.hi);
  Twin3 square = twinProduct(vec3(z.hi), vec3(z.hi));
  Twin3 back = twinProduct(vec3(rough), square.hi);
  PRECISE float low = p.lo - back.lo.x - rough * (square.lo.x + 2.0 * z.hi * z.lo);
  PRECISE float lacks = (p.hi - back.hi.x) + low;
  return rough + lacks / square.hi.x;
}

// v / |v|. v r with r about 1 / |v| is exact as a twin; what |v r|² lacks to 1 then says, to second order, how far to
// stretch: 1 / sqrt(1 + x) = 1 - x / 2 + 3 x² / 8 with |x| < 2^-20, next term below 2^-61.
Twin3 twinNormalize(vec3 v) {
  float r = inversesqrt(dot(v, v));
  Twin3 u = twinProduct(v, vec3(r));
  Twin square = twinDot(u, u);
  PRECISE float x = (square.hi - 1.0) + square.lo;
  PRECISE float stretch = x * (0.375 * x - 0.5);
  PRECISE vec3 low = u.lo + stretch * u.hi;
  return twinRenormalize(u.hi, low);
}

#endif
