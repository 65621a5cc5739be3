// tonemap.glsl: tone curves, from linear scene radiance to linear display light.
// Frame    none; linear Rec. 709 in and out. Multiply by the exposure before, encode (srgb.glsl) after.
// alpha    none. Radiance below 0 is taken as 0, above TONEMAP_CEILING as that.
// Returns  tonemapNeutral, tonemapAces, tonemapAgx: display light, each channel in [0, 1].
// Source   [KhrNeutral]; [Hill16], its fit of the ACES reference and output transforms; [Sobotka22], base look, 2.2 display.
// Limits   Aces takes the radiance as it is: three.js and others divide by 0.6 first, which is an exposure of +0.74 EV.
//          Agx is the curve and matrices of the first AgX, not of Blender's later one. NaN in is undefined out.
#ifndef GG_COLOR_TONEMAP_GLSL
#define GG_COLOR_TONEMAP_GLSL

// The largest half-precision number; keeps an infinity from becoming inf / inf. Beyond it each of the three is white to
// within 1/65504, or clipped.
const float TONEMAP_CEILING = 65504.0;

vec3 tonemapInput(vec3 radiance) { return clamp(radiance, 0.0, TONEMAP_CEILING); }

float tonemapMaxOf(vec3 c) { return max(c.x, max(c.y, c.z)); }

// Keeps base colours as they are: takes away the 4 % that a dielectric's reflection adds, compresses what is brighter
// than 0.76 by a hyperbola, and fades it to white.
vec3 tonemapNeutral(vec3 radiance) {
  const float start = 0.8 - 0.04;
  const float desaturation = 0.15;
  vec3 c = tonemapInput(radiance);
  float darkest = min(c.x, min(c.y, c.z));
  c = c - vec3(darkest < 0.08 ? darkest - 6.25 * darkest * darkest : 0.04);
  float peak = tonemapMaxOf(c);
  if (peak < start) return c;
  float room = 1.0 - start;
  float compressed = 1.0 - room * room / (peak - start + room);
  float keep = 1.0 / (desaturation * (peak - compressed) + 1.0);
  // Rounding may leave the result an ulp above 1.
  return clamp(mix(vec3(compressed), c * (compressed / peak), keep), 0.0, 1.0);
}

vec3 tonemapRows(vec3 r, vec3 g, vec3 b, vec3 c) { return vec3(dot(r, c), dot(g, c), dot(b, c)); }

// A rational fit of the reference rendering and output transforms, in its own primaries.
vec3 tonemapAces(vec3 radiance) {
  vec3 c = tonemapRows(vec3(0.59719, 0.35458, 0.04823), vec3(0.07600, 0.90834, 0.01566),
                       vec3(0.02840, 0.13383, 0.83777), tonemapInput(radiance));
  c = (c * (c + vec3(0.0245786)) - vec3(0.000090537))
      / (c * (0.983729 * c + vec3(0.4329510)) + vec3(0.238081));
  c = tonemapRows(vec3(1.60475, -0.53108, -0.07367), vec3(-0.10208, 1.10813, -0.00605),
                  vec3(-0.00327, -0.07276, 1.07602), c);
  return clamp(c, 0.0, 1.0);
}

// The sigmoid on the logarithm: slope 2 through (pivot, 1/2), from (0, 0) to (1, 1), with power 3 below the pivot and 13/4
// above. The scale 4^p - d^-p is what makes a side of width d end at its corner.
float tonemapAgxCurve(float x) {
  const float pivot = 10.0 / 16.5;
  float power = x < pivot ? 3.0 : 3.25;
  float width = x < pivot ? pivot : 1.0 - pivot;
  float scale = pow(4.0, power) - pow(width, -power);
  return 0.5 + 2.0 * (x - pivot) * pow(1.0 + scale * pow(abs(x - pivot), power), -1.0 / power);
}

// 16.5 stops, from 10 below middle grey (0.18) to 6.5 above, in slightly inset primaries, so that bright saturated
// colours go to white. The curve ends in encoded values of a 2.2 display, which are made linear again.
vec3 tonemapAgx(vec3 radiance) {
  const float blackStop = -12.473931188332413; // log2(0.18) - 10
  vec3 c = tonemapRows(vec3(0.842479062253094, 0.0784335999999992, 0.0792237451477643),
                       vec3(0.0423282422610123, 0.878468636469772, 0.0791661274605434),
                       vec3(0.0423756549057051, 0.0784336, 0.879142973793104), tonemapInput(radiance));
  vec3 stops = (log2(max(c, exp2(blackStop))) - vec3(blackStop)) / 16.5;
  stops = clamp(stops, 0.0, 1.0);
  c = vec3(tonemapAgxCurve(stops.x), tonemapAgxCurve(stops.y), tonemapAgxCurve(stops.z));
  c = tonemapRows(vec3(1.19687900512017, -0.0980208811401368, -0.0990297440797205),
                  vec3(-0.0528968517574562, 1.15190312990417, -0.0989611768448433),
                  vec3(-0.0529716355144438, -0.0980434501171241, 1.15107367264116), c);
  return pow(clamp(c, 0.0, 1.0), vec3(2.2));
}

#endif
