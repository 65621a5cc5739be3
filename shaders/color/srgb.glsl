// srgb.glsl: the transfer function of sRGB between linear light and encoded values, both ways.
// Frame    none; colours are Rec. 709 primaries, D65 white.
// alpha    none. Linear and encoded values in [0, 1]; below 0 is taken as 0, above 1 as 1.
// Returns  srgbFromLinear, srgbFromLinearRgb: encoded, in [0, 1]; linearFromSrgb, linearFromSrgbRgb: linear, in [0, 1].
// Source   [IEC61966] eq. for R'G'B' and their inverse.
// Limits   the standard's two pieces meet to 1.2e-8 (encoding) and 5.7e-9 (decoding) only, so a round trip near the joint
//          is as good as that. NaN in is undefined out.
#ifndef GG_COLOR_SRGB_GLSL
#define GG_COLOR_SRGB_GLSL

float srgbFromLinear(float linear) {
  float v = clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

float linearFromSrgb(float encoded) {
  float v = clamp(encoded, 0.0, 1.0);
  return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

vec3 srgbFromLinearRgb(vec3 linear) {
  return vec3(srgbFromLinear(linear.x), srgbFromLinear(linear.y), srgbFromLinear(linear.z));
}

vec3 linearFromSrgbRgb(vec3 encoded) {
  return vec3(linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z));
}

#endif
