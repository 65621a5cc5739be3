// fullscreen.vert: one triangle that covers the picture, at the far plane (reversed depth: 0).
#version 450

layout(location = 0) out vec2 outClip; // clip-space x, y

void main() {
    outClip = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    gl_Position = vec4(outClip, 0.0, 1.0);
}
