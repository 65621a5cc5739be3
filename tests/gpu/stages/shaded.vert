#version 450
// A triangle of a fan round the origin, turned and moved by its own block.
layout(std140, binding = 0) uniform Camera {
    mat4 clipFromWorld;
    vec4 light; // xyz: unit
};
layout(std140, binding = 1) uniform Place {
    mat4 worldFromMesh;
    vec4 color;
};
layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec4 inColor;
layout(location = 0) out vec3 outNormal;
layout(location = 1) out vec2 outUv;

void main() {
    gl_Position = clipFromWorld * worldFromMesh * vec4(inPosition, 1.0);
    outNormal = mat3(worldFromMesh) * inColor.xyz;
    outUv = inPosition.xy;
}
