// debug_view.frag: of the nearest surface its normal and distance; or, added up over all faces of solids, how far the line of sight
// runs within them: distances of back faces less those of front faces, whatever the order.
#version 450

layout(constant_id = 0) const bool sumsFaces = false;

layout(std140, binding = 0) uniform DebugDraw {
    mat4 clipFromMesh;
    mat4 worldFromMesh;
    mat4 normalFromMesh;
    vec4 eye;
} draw;

layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;

layout(location = 0) out vec4 outValue; // normal and distance; or length, faces, 0, 0

void main() {
    float distance = length(worldPosition - draw.eye.xyz);
    if (sumsFaces) {
        outValue = vec4(gl_FrontFacing ? -distance : distance, 1.0, 0.0, 0.0);
        return;
    }
    outValue = vec4(normalize(gl_FrontFacing ? worldNormal : -worldNormal), distance);
}
