// constants.glsl: numbers that several snippets share.
// Frame    none.
// alpha    none.
// Returns  BSDF_PI: the circle's half turn in radians.
// Source   definition.
// Limits   named so that it does not meet the PI macro of the program that the snippet is dropped into.
#ifndef GG_BSDF_CONSTANTS_GLSL
#define GG_BSDF_CONSTANTS_GLSL

const float BSDF_PI = 3.14159265358979323846;

#endif
