// neighbours.glsl: the neighbours of a draw, as proxies: spheres and rectangles. One text for GLSL and C++
// (app/uniforms/blocks.h).

struct NeighbourData {
    vec4 centre;   // xyz: metres; w: the sphere's radius, 0: a rectangle
    vec4 sideU;    // xyz: half of a rectangle's side, metres; w: 1 if only its front (cross(u, v)) is met
    vec4 sideV;
    vec4 f0;       // xyz: reflectance at normal incidence; w: at 90 degrees
    vec4 base;     // xyz: albedo of the diffuse base; w: alpha, width of D
    vec4 emission; // xyz: radiance; w: ior of glass, 0: opaque
    vec4 through;  // xyz: of glass, what passes both faces besides Fresnel's share; w: 1 if it is a ball, not only taken for one
};

const int MOST_NEIGHBOURS = 8;

struct NeighboursData {
    ivec4 counts; // x: neighbours, nearer ones first, those of one body together
    NeighbourData each[MOST_NEIGHBOURS + 1]; // the last: the draw's own body; base: all that it reflects
};

#ifndef __cplusplus
layout(std140, binding = 5) uniform Neighbours {
    NeighboursData neighbours;
};
#endif
