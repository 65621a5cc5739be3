// log1p.glsl: log(1 + x) for x >= 0, with all of its digits near 0.
// Frame    none.
// alpha    none.
// Returns  log1pPositive: >= 0.
// Source   log(1 + x) = 2 atanh(x / (2 + x)), [AS64] 4.1.27 and 4.6.22.
// Limits   negative x counts as 0. GLSL's own log is only absolutely accurate near 1, and the trick with (1 + x) - 1
//          may be optimised away, so the series it is: relative error below 2^-50 in double, below 3 ulp in float.
#ifndef GG_BSDF_LOG1P_GLSL
#define GG_BSDF_LOG1P_GLSL

// Past x = 0.4 halve once, log(1 + x) = 2 log(1 + x / (1 + sqrt(1 + x))), which leaves y = x' / (2 + x') <= 0.172; the
// first term left out of the atanh series is then y^22 / 23 < 7e-19. Below it the root's roundings are saved: a Phong
// lobe of exponent 1e6 multiplies them by 70 in its tail.
float log1pPositive(float x) {
  if (x > 1.0) return log(1.0 + x);
  float t = max(x, 0.0);
  bool whole = t <= 0.4;
  float h = whole ? t : t / (1.0 + sqrt(1.0 + t));
  float y = h / (2.0 + h);
  float y2 = y * y;
  float tail = 1.0 / 17.0 + y2 * (1.0 / 19.0 + y2 * (1.0 / 21.0));
  tail = 1.0 / 11.0 + y2 * (1.0 / 13.0 + y2 * (1.0 / 15.0 + y2 * tail));
  tail = 1.0 / 5.0 + y2 * (1.0 / 7.0 + y2 * (1.0 / 9.0 + y2 * tail));
  return (whole ? 2.0 : 4.0) * y * (1.0 + y2 * (1.0 / 3.0 + y2 * tail));
}

#endif
