// region_pixel.glsl: picture_pixel.glsl at the rate that the region is shaded at: one fragment for the middle of so many pixels.
// Needs    interface/region.glsl, interface/frame.glsl.
#ifndef GG_STAGES_PICTURE_PIXEL_GLSL
#define GG_STAGES_PICTURE_PIXEL_GLSL

int pixelStep() { return int(region.back.y); }

// The last ones may stand for less than the others.
ivec2 picturePixel() {
    int apart = pixelStep();
    return min(ivec2(gl_FragCoord.xy) * apart + apart / 2, ivec2(frame.picture.xy) - 1);
}

#endif
