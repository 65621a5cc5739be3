#version 450
layout(binding = 0) uniform usampler2D map;
layout(location = 0) in vec2 inUv;
layout(location = 0) out uvec4 outColor;

void main() {
    outColor = textureLod(map, inUv, 0.0);
}
