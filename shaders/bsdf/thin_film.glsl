// thin_film.glsl: Fresnel's reflectance of a film on a substrate, in linear Rec.709: iridescence.
// Frame    none: cosTheta = wo . wm in air.
// alpha    none. filmIor, baseIor: relative to air, 1 or more, real. thickness: nanometres; 0 is the bare substrate.
// Returns  filmBaseIor: of a reflectance at normal incidence in [0, 1), 1 or more. filmFresnel: [0, 1] a channel; 1 at the horizon.
// Source   [BelcourBarla17]: the film's Fourier series in the phase between its reflections, each term times the transform of the
//          eye's sensitivities at that many optical path differences (their Gaussians). The series is Airy's sum [BornWolf99
//          §7.6] by Poisson's kernel, for both polarizations, with the signs of real amplitudes.
// Limits   four terms of the series; colours by equal energy, white where the film reflects all; two Gaussians for X, one for Y
//          and for Z. Within 0.02 of an integral over the spectrum for dielectrics (tests/bsdf/thin_film.cpp). Metals are taken for
//          dielectrics of the same reflectance: their phase is lost.
#ifndef GG_BSDF_THIN_FILM_GLSL
#define GG_BSDF_THIN_FILM_GLSL

#include "bsdf/constants.glsl"

// A substrate of reflectance 1 has no index: 0.9999 stands for it, of index 4e4.
float filmBaseIor(float f0) {
  float r = sqrt(clamp(f0, 0.0, 0.9999));
  return (1.0 + r) / (1.0 - r);
}

// Amplitudes reflected from one medium at another: x across the plane of incidence, y in it.
vec2 filmAmplitudes(float nearIor, float nearCos, float farIor, float farCos) {
  float across = nearIor * nearCos + farIor * farCos;
  float within = farIor * nearCos + nearIor * farCos;
  return vec2(across > 0.0 ? (nearIor * nearCos - farIor * farCos) / across : 0.0,
              within > 0.0 ? (farIor * nearCos - nearIor * farCos) / within : 0.0);
}

// Of each channel the mean of cos(2 pi opd / wavelength) over its sensitivity; opd: metres. 1 at 0.
vec3 filmCosines(float opd) {
  float k = 2.0 * BSDF_PI * opd;
  float k2 = k * k;
  float x = 0.8462 * cos(1.6810e6 * k) * exp(-4.3278e9 * k2) + 0.1538 * cos(2.2399e6 * k) * exp(-4.5282e9 * k2);
  float y = cos(1.7953e6 * k) * exp(-9.3046e9 * k2);
  float z = cos(2.2084e6 * k) * exp(-6.6121e9 * k2);
  // XYZ to Rec.709, each row divided by its sum: what reflects all is white under equal energy.
  return vec3(2.689655 * x - 1.275862 * y - 0.413793 * z, -1.022107 * x + 1.978286 * y + 0.043821 * z,
              0.061225 * x - 0.224490 * y + 1.163265 * z);
}

// One polarization, one channel. a, b: amplitudes at the film's two faces; cosines: of one, two and three differences.
float filmSeries(float a, float b, vec3 cosines) {
  float q = -a * b;
  float t = (1.0 - a * a) * (1.0 - b * b) / max(1.0 - q * q, 1e-9); // 0 / 0 where both faces reflect all
  return 1.0 - t * (1.0 + 2.0 * q * (cosines.x + q * (cosines.y + q * cosines.z)));
}

float filmChannel(vec2 first, float sin2, float filmIor, float filmCos, float baseIor, vec3 cosines) {
  float baseCos = sqrt(max(1.0 - sin2 / (baseIor * baseIor), 0.0));
  vec2 second = filmAmplitudes(filmIor, filmCos, baseIor, baseCos);
  return clamp(0.5 * (filmSeries(first.x, second.x, cosines) + filmSeries(first.y, second.y, cosines)), 0.0, 1.0);
}

vec3 filmFresnel(float cosTheta, float filmIor, float thickness, vec3 baseIor) {
  float c = clamp(cosTheta, 0.0, 1.0);
  if (!(c > 0.0)) return vec3(1.0);
  float sin2 = 1.0 - c * c;
  float filmCos = sqrt(max(1.0 - sin2 / (filmIor * filmIor), 0.0));
  vec2 first = filmAmplitudes(1.0, c, filmIor, filmCos);
  float opd = 2.0e-9 * filmIor * thickness * filmCos;
  vec3 one = filmCosines(opd);
  vec3 two = filmCosines(2.0 * opd);
  vec3 three = filmCosines(3.0 * opd);
  return vec3(filmChannel(first, sin2, filmIor, filmCos, baseIor.x, vec3(one.x, two.x, three.x)),
              filmChannel(first, sin2, filmIor, filmCos, baseIor.y, vec3(one.y, two.y, three.y)),
              filmChannel(first, sin2, filmIor, filmCos, baseIor.z, vec3(one.z, two.z, three.z)));
}

#endif
