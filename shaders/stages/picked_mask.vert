// picked_mask.vert: the mesh of the picked object.
#version 450

layout(std140, binding = 0) uniform Picked {
    mat4 clipFromMesh;
};

layout(location = 0) in vec3 position;

void main() { gl_Position = clipFromMesh * vec4(position, 1.0); }
