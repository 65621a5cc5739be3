// region.glsl: a part of the picture that takes deferred shading. One text for GLSL and C++ (app/uniforms/blocks.h).

struct RegionData {
    vec4 box;  // clip coordinates over w: left, bottom, right, top
    vec4 back; // x: of glass the farthest depth of what is in it, of opaque surfaces a number of its own (material_depth.frag);
               // y: of glass, pixels per side that one fragment stands for; z: of glass, the number of the solid
               // (stages/object.glsl); w: none
};

const float REGION_STEP = 1.0 / 16777216.0; // between the numbers of opaque surfaces: exact in floats

#ifndef __cplusplus
layout(std140, binding = 4) uniform Region {
    RegionData region;
};
#endif
