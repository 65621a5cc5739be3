#version 450
layout(binding = 0) uniform sampler2D map;
layout(location = 0) in vec2 inUv;
layout(location = 0) out vec4 outColor;
layout(constant_id = 0) const float level = 0.0;
layout(constant_id = 1) const float shift = 0.0;

void main() {
    outColor = textureLod(map, inUv + vec2(shift), level);
}
