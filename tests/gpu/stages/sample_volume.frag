#version 450
layout(binding = 0) uniform sampler3D map;
layout(location = 0) in vec2 inUv;
layout(location = 0) out vec4 outColor;
layout(constant_id = 0) const float depth = 0.0;

void main() {
    outColor = textureLod(map, vec3(inUv, depth), 0.0);
}
