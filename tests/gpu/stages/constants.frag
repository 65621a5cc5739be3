#version 450
// Each kind of constant, and a texture that only a feature reads.
layout(constant_id = 0) const bool useMap = false;
layout(constant_id = 1) const int steps = 1;
layout(constant_id = 2) const uint big = 7u;
layout(constant_id = 3) const float scale = 0.5;
layout(constant_id = 5) const bool useTable = false;

layout(binding = 3) uniform sampler2D map;
layout(std140, binding = 4) uniform Table { vec4 entry; };
layout(location = 0) in vec2 inUv;
layout(location = 0) out vec4 outColor;

vec4 looked() {
    return texture(map, inUv);
}

void main() {
    float sum = 0.0;
    for (int i = 0; i < steps; ++i) sum += scale;
    outColor = vec4(sum, float(big), scale, 0.0);
    if (useMap) outColor += looked();
    if (useMap && useTable) outColor += entry;
}
