// fresnel_conductor.glsl: Fresnel's equations at an absorbing medium of complex index n + i k, exact.
// Frame    none; c = |wo . wm| in [0, 1] (clamped).
// alpha    none. n >= 0, k >= 0: real and imaginary part of the metal's index over the outer medium's, per colour
//          channel.
// Returns  fresnelConductor: reflectance F in [0, 1], unpolarised; fresnelConductorRgb: three channels;
//          fresnelAbsorbed: 1 - F without the subtraction.
// Source   [BornWolf99] 14.2 eq. 11-15, in the smaller-part form below.
// Limits   negative n or k count as 0. k = 0 is the dielectric of index n, with total reflection where n < sin.
#ifndef GG_BSDF_FRESNEL_CONDUCTOR_GLSL
#define GG_BSDF_FRESNEL_CONDUCTOR_GLSL

// The four sums of squares that both reflectances are made of, Rs = numS / denS and Rp = Rs numP / denP.
struct ConductorTerms {
  float a;  // real part of q = sqrt((n + i k)² - sin²)
  float q2; // |q|²
  float numS;
  float denS;
  float numP;
  float denP;
};

ConductorTerms conductorTerms(float c, float n, float k) {
  float sin2 = (1.0 - c) * (1.0 + c);
  float contrast = (n - 1.0) * (n + 1.0) - k * k;
  float re = contrast + c * c; // q² = re + 2 i n k
  float nk = n * k;
  // The larger part of q by a sum, the smaller from the product of the two, which is n k: neither cancels.
  float larger = sqrt(0.5 * (abs(re) + sqrt(re * re + 4.0 * nk * nk)));
  float smaller = larger > 0.0 ? nk / larger : 0.0;
  float a = re > 0.0 ? larger : smaller;
  float b = re > 0.0 ? smaller : larger;
  // a - c by way of a² - c² = contrast + b²: exact as n -> 1, k -> 0, where a and c agree in every digit.
  float aMinusC = a + c > 0.0 ? (contrast + b * b) / (a + c) : 0.0;
  float bc = b * c;
  ConductorTerms t;
  t.a = a;
  t.q2 = a * a + b * b;
  t.numS = aMinusC * aMinusC + b * b;
  t.denS = (a + c) * (a + c) + b * b;
  t.numP = (a * c - sin2) * (a * c - sin2) + bc * bc;
  t.denP = (a * c + sin2) * (a * c + sin2) + bc * bc;
  return t;
}

float fresnelConductor(float cosTheta, float n, float k) {
  float c = clamp(abs(cosTheta), 0.0, 1.0);
  ConductorTerms t = conductorTerms(c, max(n, 0.0), max(k, 0.0));
  // denS = 0 only for index 0 seen along the horizon, denP = 0 only for index 0: both reflect everything.
  float rs = t.denS > 0.0 ? t.numS / t.denS : 1.0;
  float rpOverRs = t.denP > 0.0 ? t.numP / t.denP : 1.0;
  return min(0.5 * rs * (1.0 + rpOverRs), 1.0);
}

// What the metal absorbs. 1 - Rs = 4 a c / denS and 1 - Rp = 4 a c (|q|² + sin²) / (denS denP), by expanding the
// squares.
float fresnelAbsorbed(float cosTheta, float n, float k) {
  float c = clamp(abs(cosTheta), 0.0, 1.0);
  ConductorTerms t = conductorTerms(c, max(n, 0.0), max(k, 0.0));
  if (!(t.denS > 0.0 && t.denP > 0.0)) return 0.0;
  float sin2 = (1.0 - c) * (1.0 + c);
  return min(2.0 * t.a * c / t.denS * (1.0 + (t.q2 + sin2) / t.denP), 1.0);
}

vec3 fresnelConductorRgb(float cosTheta, vec3 n, vec3 k) {
  return vec3(fresnelConductor(cosTheta, n.x, k.x), fresnelConductor(cosTheta, n.y, k.y),
              fresnelConductor(cosTheta, n.z, k.z));
}

#endif
