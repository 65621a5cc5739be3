#version 450
layout(std140, binding = 3) uniform Table { vec4 entry; };
layout(location = 0) out vec2 outUv;

void main() {
    outUv = entry.xy;
    gl_Position = entry;
}
