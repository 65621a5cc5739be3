// fresnel_dielectric.glsl: Fresnel's equations at an interface between two clear media, exact.
// Frame    none; c = |wo . wm| in [0, 1] (clamped), the cosine on the known side.
// alpha    none. eta = n_far / n_known > 0; 1 returns F = 0, 0 or less is opaque and returns F = 1.
// Returns  fresnelG: eta times the far cosine, 0 past the critical angle. fresnelDielectric: reflectance F in [0, 1]
//          for unpolarised light; fresnelTransmitted: 1 - F without the subtraction; fresnelPolarized: reflectances
//          of the two polarisations. The ...At forms take only the angle and the index.
// Source   [Walter07] eq. 22, factored; [BornWolf99] 1.5.2.
// Limits   no absorption, no interference, no phase. Near the critical angle F has a square-root edge: half an ulp of c
//          there is 2e-4 of F in float32, whatever the formula.
#ifndef GG_BSDF_FRESNEL_DIELECTRIC_GLSL
#define GG_BSDF_FRESNEL_DIELECTRIC_GLSL

// Reflectances of light polarised across (s) and in (p) the plane of incidence.
struct Polarized {
  float s;
  float p;
};

// g = sqrt(eta² - sin²) = eta cos of the far side. (eta - 1)(eta + 1) + c² keeps its digits as eta -> 1.
float fresnelG(float c, float eta) {
  return sqrt(max((eta - 1.0) * (eta + 1.0) + c * c, 0.0));
}

// rs = (c - g) / (c + g) with (c - g)(c + g) = 1 - eta² =: -K, and rp = rs cos(i + t) / cos(i - t): neither subtracts
// what is nearly equal, but for c g - sin² at Brewster's angle, where rp is to vanish. sin² comes from the rarer
// side, where it is larger: (1 - c)(1 + c) of the known side keeps few digits where all angles are small, at eta < 1.
Polarized fresnelPolarized(float c, float g, float eta) {
  Polarized r;
  r.s = eta == 1.0 ? 0.0 : 1.0;
  r.p = r.s;
  if (g > 0.0 && eta > 0.0) {
    float k = (eta - 1.0) * (eta + 1.0);
    float sin2 = eta < 1.0 ? (eta - g) * (eta + g) : (1.0 - c) * (1.0 + c);
    float across = c + g;
    float along = (c * g - sin2) / (c * g + sin2);
    float rs = k / (across * across);
    float rp = rs * along;
    r.s = min(rs * rs, 1.0);
    r.p = min(rp * rp, 1.0);
  }
  return r;
}

float fresnelDielectric(float c, float g, float eta) {
  Polarized r = fresnelPolarized(c, g, eta);
  return 0.5 * (r.s + r.p);
}

// 1 - F = 2 c g (1 / (c + g)² + eta² / (eta² c + g)²): each term is 1 - r² of one polarisation, factored.
float fresnelTransmitted(float c, float g, float eta) {
  if (eta == 1.0) return 1.0;
  if (!(g > 0.0 && eta > 0.0)) return 0.0;
  float eta2 = eta * eta;
  float across = c + g;
  float along = eta2 * c + g;
  return min(2.0 * c * g * (1.0 / (across * across) + eta2 / (along * along)), 1.0);
}

float fresnelDielectricAt(float cosTheta, float eta) {
  float c = clamp(abs(cosTheta), 0.0, 1.0);
  return fresnelDielectric(c, fresnelG(c, eta), eta);
}

float fresnelTransmittedAt(float cosTheta, float eta) {
  float c = clamp(abs(cosTheta), 0.0, 1.0);
  return fresnelTransmitted(c, fresnelG(c, eta), eta);
}

Polarized fresnelPolarizedAt(float cosTheta, float eta) {
  float c = clamp(abs(cosTheta), 0.0, 1.0);
  return fresnelPolarized(c, fresnelG(c, eta), eta);
}

// Reflectance at normal incidence, ((eta - 1) / (eta + 1))²: 0.04 for 1.5.
float fresnelNormalIncidence(float eta) {
  float r = (eta - 1.0) / (eta + 1.0);
  return r * r;
}

#endif
