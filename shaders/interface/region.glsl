// region.glsl: the part of the picture that one solid is in. One text for GLSL and C++ (app/uniforms/blocks.h).

struct RegionData {
    vec4 box;  // clip coordinates over w: left, bottom, right, top
    vec4 back; // x: the farthest depth of what is in it; y, z, w: none
};

#ifndef __cplusplus
layout(std140, binding = 4) uniform Region {
    RegionData region;
};
#endif
