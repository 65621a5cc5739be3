#version 450
// One triangle over everything; outUv is 0, 0 in the corner of row 0.
layout(location = 0) out vec2 outUv;

void main() {
    outUv = vec2(gl_VertexIndex == 1 ? 2.0 : 0.0, gl_VertexIndex == 2 ? 2.0 : 0.0);
    gl_Position = vec4(2.0 * outUv.x - 1.0, 1.0 - 2.0 * outUv.y, 0.0, 1.0);
}
