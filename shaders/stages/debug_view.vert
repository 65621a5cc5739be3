// debug_view.vert: meshes for the debug views of the viewer (app/viewer/debug_view.cpp).
#version 450

layout(std140, binding = 0) uniform DebugDraw {
    mat4 clipFromMesh;
    mat4 worldFromMesh;
    mat4 normalFromMesh;
    vec4 eye; // world; w unused
} draw;

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;

layout(location = 0) out vec3 worldPosition;
layout(location = 1) out vec3 worldNormal;

void main() {
    worldPosition = (draw.worldFromMesh * vec4(inPosition, 1.0)).xyz;
    worldNormal = mat3(draw.normalFromMesh) * inNormal;
    gl_Position = draw.clipFromMesh * vec4(inPosition, 1.0);
}
