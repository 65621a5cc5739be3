// display.glsl: how the viewer shows a picture. One text for GLSL and C++ (app/viewer/display_pass.cpp).

struct DisplayData {
    vec4 area;    // x, y: width and height of the picture on the screen, pixels; the others are unused
    vec4 picture; // x: factor on its values; the others are unused
    vec4 other;   // x: factor on its values; y: 1 encoded for display already; z: where it begins, as a part of the width; w: 1 both
                  // pictures are halves side by side, each cut from its middle
    vec4 around;  // encoded colour of what is not picture
};

#ifndef __cplusplus
layout(std140, binding = 0) uniform Display {
    DisplayData display;
};
#endif
