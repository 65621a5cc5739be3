// pyramid.frag: one level of the screen pyramid from the one before.
// [1 3 3 1] / 8 along each axis as two bilinear lookups: between texels 0 and 1 at weights 1 : 3, between 2 and 3 at 3 : 1.
#version 450

layout(binding = 8) uniform sampler2D finer; // one level

layout(location = 0) in vec2 inClip;
layout(location = 0) out vec4 outColor;

void main() {
    vec2 size = vec2(textureSize(finer, 0));
    // The centre of this texel in the finer level, whose odd last row or column belongs to the last texel.
    vec2 centre = (0.5 + 0.5 * vec2(inClip.x, -inClip.y)) * size;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; k++) {
        vec2 at = centre + vec2((k & 1) == 0 ? -0.75 : 0.75, (k & 2) == 0 ? -0.75 : 0.75);
        sum += textureLod(finer, at / size, 0.0);
    }
    outColor = 0.25 * sum;
}
