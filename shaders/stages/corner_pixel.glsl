// corner_pixel.glsl: picture_pixel.glsl for fragments that stand for the corners of cells.
// Needs    interface/region.glsl, interface/frame.glsl.
#ifndef GG_STAGES_PICTURE_PIXEL_GLSL
#define GG_STAGES_PICTURE_PIXEL_GLSL

int pixelStep() { return CELL_STEP; }

// The last corners lie beyond the picture: its last pixels stand for them.
ivec2 picturePixel() { return min(ivec2(gl_FragCoord.xy) * CELL_STEP, ivec2(frame.picture.xy) - 1); }

#endif
