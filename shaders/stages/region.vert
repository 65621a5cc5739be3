// region.vert: the part of the picture that a region is in, as two triangles that face the viewer, at a depth of its own.
#version 450
#include "interface/region.glsl"

void main() {
    // Corners 0 1 2, 0 2 3, counter-clockwise from the lower left one.
    int corner = gl_VertexIndex < 3 ? gl_VertexIndex : gl_VertexIndex == 3 ? 0 : gl_VertexIndex - 2;
    bool right = corner == 1 || corner == 2;
    bool top = corner > 1;
    gl_Position = vec4(right ? region.box.z : region.box.x, top ? region.box.w : region.box.y, region.back.x, 1.0);
}
