#version 450
// Writes its own coordinates into every layer.
layout(local_size_x = 1) in;
layout(rgba32f, binding = 0) writeonly uniform image3D to;

void main() {
    ivec3 texel = ivec3(gl_WorkGroupID);
    imageStore(to, texel, vec4(texel, 1.0));
}
