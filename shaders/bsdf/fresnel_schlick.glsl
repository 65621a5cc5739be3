// fresnel_schlick.glsl: Schlick's approximation of Fresnel reflectance, by its name so that nobody takes it for exact.
// Frame    none; cosTheta = |wo . wm| in [0, 1] (clamped); from inside a denser medium pass the cosine on the outside.
// alpha    none. f0: reflectance at normal incidence, in [0, 1].
// Returns  fresnelSchlick, fresnelSchlickRgb: reflectance in [f0, 1].
// Source   [Schlick94] eq. 15.
// Limits   knows no polarisation, no total reflection and no Brewster angle. Worst absolute error against the exact
//          mean: 0.036 for eta 1.5, 0.210 for eta 1.1, 0.074 for eta 2.4, all near 84 degrees (tests/bsdf holds them).
#ifndef GG_BSDF_FRESNEL_SCHLICK_GLSL
#define GG_BSDF_FRESNEL_SCHLICK_GLSL

float schlickWeight(float cosTheta) {
  float m = 1.0 - clamp(cosTheta, 0.0, 1.0);
  float m2 = m * m;
  return m2 * m2 * m;
}

float fresnelSchlick(float cosTheta, float f0) { return f0 + (1.0 - f0) * schlickWeight(cosTheta); }

vec3 fresnelSchlickRgb(float cosTheta, vec3 f0) {
  return f0 + (vec3(1.0) - f0) * schlickWeight(cosTheta);
}

#endif
