// region.glsl: a part of the picture that takes deferred shading. One text for GLSL and C++ (app/uniforms/blocks.h).

struct RegionData {
    vec4 box;  // clip coordinates over w: left, bottom, right, top
    vec4 back; // x: of glass the farthest depth of what is in it, of opaque surfaces a number of its own (material_depth.frag);
               // y: of glass, pixels per side that one fragment stands for; z: of glass, the number of the solid
               // (stages/object.glsl), of all opaque regions together how many there are; w: none
};

const float REGION_STEP = 1.0 / 16777216.0; // between the numbers of opaque surfaces: exact in floats
const int CELL_STEP = 4; // pixels per side of the cells in which neighbours' light is interpolated (stages/neighbour_light.glsl)

#ifndef __cplusplus
const float CELL_COSINE = 0.95; // at least: between normals of one cell

layout(std140, binding = 4) uniform Region {
    RegionData region;
};
#endif
