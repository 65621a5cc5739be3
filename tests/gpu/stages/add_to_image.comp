#version 450
// Adds the texture's texels to the image's.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D from;
layout(rgba32f, binding = 1) uniform image2D to;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    imageStore(to, texel, imageLoad(to, texel) + texelFetch(from, texel, 0));
}
