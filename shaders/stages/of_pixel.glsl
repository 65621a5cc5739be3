// of_pixel.glsl: makes a uniform value that branches or loops depend on look different for each pixel.
// Returns  the same number: gl_FragCoord is positive.
// Limits   fragment stages only.
// lavapipe (Mesa 22.3) recompiles a shader at every draw for the values of uniforms that its branches test: 24 ms each, seconds
// where Mesa's cache is too small for all of them. It does not do so for values that depend on the pixel.
#ifndef GG_STAGES_OF_PIXEL_GLSL
#define GG_STAGES_OF_PIXEL_GLSL

int ofPixel(int number) { return number + int(min(gl_FragCoord.x, 0.0)); }
float ofPixel(float number) { return number + min(gl_FragCoord.x, 0.0); }

#endif
