// gaussian_stack.glsl: a map blurred by Gaussians of known sigma, sqrt(2) apart, and which of its levels stand for a sigma.
// Frame    world of the map: environmentRotate turns world directions into it.
// alpha    none; sigma: radians per axis, >= 0, exp(-l(l+1) sigma²/2) on the sphere.
// Returns  gaussianStackLevels: levels of the two cubes that the stack is kept in, and the odd one's share.
//          Levels by growing sigma: even 0 (sharp), even 1, odd 0, even 2, odd 1, even 3, ... Faces halve with every second.
// Source   app/environment/stack.h. stack = Stack::shape: x sigma of even 0, y sigma of
//          even 1, both with the blur of bilinear lookup in them, z number of levels past even 1, w radiance of one stored unit.
// Limits   between two levels the mix keeps the variance, hence smooth maps to the second order; the peak of a point of
//          light is up to 12 % too high half-way. On made-up HDR maps the RMS log error half-way is .057, .15 with levels
//          a factor 2 apart. Wider than the last level counts as the last.
#ifndef GG_ENVIRONMENT_GAUSSIAN_STACK_GLSL
#define GG_ENVIRONMENT_GAUSSIAN_STACK_GLSL

struct StackLevels {
  float even; // fractional between 0 and 1 only: read with linear filtering between levels
  float odd;
  float oddShare;
};

StackLevels gaussianStackLevels(vec4 stack, float sigma) {
  float variance = sigma * sigma;
  float first = stack.y * stack.y;
  float sharp = stack.x * stack.x;
  StackLevels levels;
  if (variance < first) {
    levels.even = clamp((variance - sharp) / (first - sharp), 0.0, 1.0);
    levels.odd = 0.0;
    levels.oddShare = 0.0;
    return levels;
  }
  float height = min(log2(variance / first), stack.z); // in levels: each has twice the variance
  float below = min(floor(height), stack.z - 1.0);
  float share = exp2(height - below) - 1.0; // of the level above
  float pair = floor(0.5 * below + 0.25);
  bool belowIsEven = below - 2.0 * pair < 0.5;
  levels.even = belowIsEven ? pair + 1.0 : pair + 2.0;
  levels.odd = pair;
  levels.oddShare = belowIsEven ? share : 1.0 - share;
  return levels;
}

// World direction -> direction in the map, for an environment turned by that angle about +Y, counter-clockwise seen from
// above (cosine and sine of it).
vec3 environmentRotate(vec3 d, float cosAngle, float sinAngle) {
  return vec3(cosAngle * d.x - sinAngle * d.z, d.y, sinAngle * d.x + cosAngle * d.z);
}

#endif
