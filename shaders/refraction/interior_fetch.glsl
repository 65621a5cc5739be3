// interior_fetch.glsl: reads interior layers (stages/interior.frag): the surfaces of a solid, one behind the other.
// Frame    that of exit_surface.glsl. Slices of the array: F1 nearest front face, B1 nearest back face, F2 and B2 the pair
//          behind. A texel: x bits of the depth, 0 where there is nothing; y outward normal (octEncode, packSnorm2x16);
//          z alpha (packHalf2x16, lower half) and, where faces differ, the root of the base colour (packInteriorTint, upper
//          half); w the number of its solid (stages/object.glsl), from 1, below 2^24, and above that 255 times the share that is
//          not clear.
// alpha    width of D at the surface, in [0, 1].
// Returns  interiorNumber: of the texel's solid. packInteriorTint, interiorTint: a colour in [0, 1] as 5, 6 and 5 bits: exact
//          where it is 0 or 1, else within 1/62. packInteriorClear, interiorClear: the clear share, within 1/510.
//          interiorDepths: of F1 B1 F2 B2; 0 where there is nothing of this solid.
//          interiorThickness: metres from the solid's front to its back at a texel; 0 where there is no back face.
//          interiorSurface: point and outward normal that a texel holds.
// Source   exit_search.glsl.
// Limits   texels must lie in the picture. pairs: 1 reads F1 and B1 only.
#ifndef GG_REFRACTION_INTERIOR_FETCH_GLSL
#define GG_REFRACTION_INTERIOR_FETCH_GLSL

#include "refraction/exit_search.glsl"

const int INTERIOR_F1 = 0;
const int INTERIOR_B1 = 1;

float interiorNumber(uvec4 bits) { return float(bits.w & 0xffffffu); }

uint packInteriorTint(vec3 tint) {
  vec3 whole = floor(clamp(tint, vec3(0.0), vec3(1.0)) * vec3(31.0, 63.0, 31.0) + 0.5);
  return (uint(whole.x) << 27u) | (uint(whole.y) << 21u) | (uint(whole.z) << 16u);
}

vec3 interiorTint(uvec4 bits) {
  return vec3(float(bits.z >> 27u) / 31.0, float((bits.z >> 21u) & 63u) / 63.0, float((bits.z >> 16u) & 31u) / 31.0);
}

uint packInteriorClear(float clear) { return uint(floor((1.0 - clamp(clear, 0.0, 1.0)) * 255.0 + 0.5)) << 24u; }

float interiorClear(uvec4 bits) { return 1.0 - float(bits.w >> 24u) / 255.0; }

float interiorDepth(usampler2DArray interior, ivec2 at, int layer, float solid) {
  uvec4 bits = texelFetch(interior, ivec3(at, layer), 0);
  return interiorNumber(bits) == solid ? uintBitsToFloat(bits.x) : 0.0;
}

vec4 interiorDepths(usampler2DArray interior, int pairs, ivec2 at, float solid) {
  vec4 depths = vec4(0.0);
  depths.x = interiorDepth(interior, at, INTERIOR_F1, solid);
  depths.y = interiorDepth(interior, at, INTERIOR_B1, solid);
  if (pairs < 2) return depths;
  depths.z = interiorDepth(interior, at, INTERIOR_F1 + 2, solid);
  depths.w = interiorDepth(interior, at, INTERIOR_B1 + 2, solid);
  return depths;
}

float interiorThickness(usampler2DArray interior, InteriorView view, ivec2 at, float solid) {
  float front = interiorDepth(interior, at, INTERIOR_F1, solid);
  float back = interiorDepth(interior, at, INTERIOR_B1, solid);
  // Without a front face before it the way to the back face starts at the near plane.
  if (front < back) front = 1.0;
  vec2 centre = vec2(at) + 0.5;
  return back > 0.0 ? distance(interiorWorld(view, centre, front), interiorWorld(view, centre, back)) : 0.0;
}

struct InteriorSurface {
  vec3 point;
  vec3 n;
};

InteriorSurface interiorSurface(InteriorView view, uvec4 bits, ivec2 at) {
  InteriorSurface s;
  s.point = interiorWorld(view, vec2(at) + 0.5, uintBitsToFloat(bits.x));
  s.n = octDecode(unpackSnorm2x16(bits.y));
  return s;
}

#endif
