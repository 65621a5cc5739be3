#version 450
layout(local_size_x = 4, local_size_y = 4) in;
layout(r32ui, binding = 20) readonly uniform uimage2D from;
layout(r32ui, binding = 21) writeonly uniform uimage2D to;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(texel, imageSize(to)))) imageStore(to, texel, 2u * imageLoad(from, texel));
}
