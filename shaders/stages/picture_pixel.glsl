// picture_pixel.glsl: the pixel of the picture that belongs to a fragment.
// Returns  picturePixel: that pixel. pixelStep: how many pixels lie between those of neighbouring fragments. Stages that run at
//          less than one fragment per pixel include stages/region_pixel.glsl in its place.
#ifndef GG_STAGES_PICTURE_PIXEL_GLSL
#define GG_STAGES_PICTURE_PIXEL_GLSL

ivec2 picturePixel() { return ivec2(gl_FragCoord.xy); }

int pixelStep() { return 1; }

#endif
