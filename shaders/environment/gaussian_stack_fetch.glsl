// gaussian_stack_fetch.glsl: reads a Gaussian stack.
// Frame    of the map (environmentRotate); directions need not be unit.
// alpha    none; sigma: radians.
// Returns  environmentRadiance: linear Rec.709 radiance, the map seen through a Gaussian of that sigma. environmentSharp: the map
//          itself. environmentIrradiance: the mean radiance with weight cos / pi about n, so albedo times it is radiance.
// Source   gaussian_stack.glsl.
// Limits   those of gaussian_stack.glsl. Samplers: linear, also between levels.
#ifndef GG_ENVIRONMENT_GAUSSIAN_STACK_FETCH_GLSL
#define GG_ENVIRONMENT_GAUSSIAN_STACK_FETCH_GLSL

#include "environment/gaussian_stack.glsl"

vec3 environmentRadiance(samplerCube even, samplerCube odd, vec4 stack, vec3 direction, float sigma) {
  StackLevels levels = gaussianStackLevels(stack, sigma);
  vec4 a = textureLod(even, direction, levels.even);
  vec4 b = textureLod(odd, direction, levels.odd);
  return stack.w * mix(a, b, levels.oddShare).xyz;
}

vec3 environmentSharp(samplerCube even, vec4 stack, vec3 direction) {
  return stack.w * textureLod(even, direction, 0.0).xyz;
}

vec3 environmentIrradiance(samplerCube irradiance, vec4 stack, vec3 n) {
  return stack.w * textureLod(irradiance, n, 0.0).xyz;
}

#endif
