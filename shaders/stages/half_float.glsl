// half_float.glsl: rounding to what a half float holds, before storing.
// Frame    none.
// alpha    none.
// Returns  roundToHalf: the nearest numbers with 11 significant bits, so that storing them is exact.
// Source   IEEE 754 binary16.
// Limits   finite numbers; those below 6e-5 (half's denormals) are still cut by the store. Implementations may store by
//          cutting off, and llvmpipe does: 0.035 % of the light per level on average, 1 % down a Gaussian stack.
#ifndef GG_STAGES_HALF_FLOAT_GLSL
#define GG_STAGES_HALF_FLOAT_GLSL

// Half of the last bit kept is added, and the 13 bits below it are cleared.
float roundToHalf(float x) { return uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xffffe000u); }

vec4 roundToHalfFour(vec4 v) { return vec4(roundToHalf(v.x), roundToHalf(v.y), roundToHalf(v.z), roundToHalf(v.w)); }

vec3 roundToHalfRgb(vec3 v) { return vec3(roundToHalf(v.x), roundToHalf(v.y), roundToHalf(v.z)); }

#endif
