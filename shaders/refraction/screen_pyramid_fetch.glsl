// screen_pyramid_fetch.glsl: reads a screen pyramid.
// Frame    pixels of the full picture.
// alpha    none; variance: pixels².
// Returns  fetchPyramid: radiance in rgb, multiplied by the share w, in [0, 1], of the blur that falls on what may be seen
//          through the glass (nearer things are cut out).
// Source   screen_pyramid.glsl.
// Limits   those of screen_pyramid.glsl. The sampler is linear, also between levels, and clamps to the edge.
#ifndef GG_REFRACTION_SCREEN_PYRAMID_FETCH_GLSL
#define GG_REFRACTION_SCREEN_PYRAMID_FETCH_GLSL

#include "refraction/screen_pyramid.glsl"

vec4 fetchPyramid(sampler2D pyramid, vec2 at, vec2 size, float variance, float lastLevel) {
  return textureLod(pyramid, at / size, pyramidLevel(variance, lastLevel));
}

#endif
