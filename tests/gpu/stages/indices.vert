#version 450
// A square per instance, `side` wide: its corner from the vertex index, its place from the instance
// index, its colour from an attribute per instance times one that all vertices share.
layout(location = 0) in vec4 inColor;  // per instance
layout(location = 1) in vec4 inShared; // stride 0
layout(location = 0) out vec4 outColor;

void main() {
    int i = gl_VertexIndex;
    vec2 corner = vec2(i == 1 || i >= 4 ? 1.0 : 0.0, i == 2 || i == 3 || i == 5 ? 1.0 : 0.0);
    float side = 0.5;
    vec2 position = vec2(-1.0 + side * (float(gl_InstanceIndex) + corner.x), 1.0 - 2.0 * corner.y);
    gl_Position = vec4(position, 0.0, 1.0);
    outColor = inColor * inShared;
}
