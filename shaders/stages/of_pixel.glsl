// of_pixel.glsl: a number of a uniform block that a branch or a loop asks for, as the pixel's own.
// Returns  the same number: gl_FragCoord is positive.
// Limits   fragment stages only.
// lavapipe (Mesa 22.3) makes a shader anew for the uniforms that its branches test, at every draw: 24 ms for each, seconds
// where Mesa's cache does not hold them all. What depends on the pixel it leaves alone.
#ifndef GG_STAGES_OF_PIXEL_GLSL
#define GG_STAGES_OF_PIXEL_GLSL

int ofPixel(int number) { return number + int(min(gl_FragCoord.x, 0.0)); }
float ofPixel(float number) { return number + min(gl_FragCoord.x, 0.0); }

#endif
