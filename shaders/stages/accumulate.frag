// accumulate.frag: adds one sub-pixel sample to the average. The target blends by adding.
#version 450

layout(constant_id = 0) const float weight = 1.0; // 1 / number of samples

layout(binding = 8) uniform sampler2D sampleColor;
layout(location = 0) out vec4 outColor;

void main() {
    outColor = weight * texelFetch(sampleColor, ivec2(gl_FragCoord.xy), 0);
}
