// constants.glsl: numbers that several snippets share.
// Frame    none.
// alpha    none.
// Returns  BSDF_PI: the circle's half turn in radians. The others bound what is divided by, as each says.
// Source   definition.
// Limits   named so that it does not meet the PI macro of the program that the snippet is dropped into.
#ifndef GG_BSDF_CONSTANTS_GLSL
#define GG_BSDF_CONSTANTS_GLSL

const float BSDF_PI = 3.14159265358979323846;

// A divisor that is 0 only where its numerator is 0 too (a mean whose weights are all 0) is bounded by this, and the quotient is 0.
// Far below what a float32 sum can tell from 0 (2^-24 of its largest term), far above the least float32 (1.2e-38).
const float LEAST_DIVISOR = 1e-30;
// A difference of unit vectors that is shorter has no direction: components of unit vectors are rounded by 2^-25 = 3e-8 each, by a
// few times that where they have been computed.
const float LEAST_LENGTH = 1e-6;
const float LEAST_LENGTH2 = 1e-12; // its square
// Shares of a pixel's light that are smaller are lost when they are added to the rest in float32.
const float LEAST_WEIGHT = 1e-6;
// A direction is not nearer to the horizon than a hundredth of a degree: interpolated normals are not known better, and
// a ball shows 1e-8 of its disc there.
const float LEAST_COSINE = 1e-4;

#endif
