#version 450
layout(local_size_x = 4, local_size_y = 4) in;
layout(r32f, binding = 20) readonly uniform image2D from;
layout(r32f, binding = 21) writeonly uniform image2D to;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(texel, imageSize(to)))) imageStore(to, texel, 2.0 * imageLoad(from, texel));
}
