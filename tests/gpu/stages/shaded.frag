#version 450
layout(std140, binding = 0) uniform Camera {
    mat4 clipFromWorld;
    vec4 light;
};
layout(std140, binding = 1) uniform Place {
    mat4 worldFromMesh;
    vec4 color;
};
layout(binding = 2) uniform sampler2D map;
layout(binding = 3) uniform samplerCube sky;
layout(location = 0) in vec3 inNormal;
layout(location = 1) in vec2 inUv;
layout(location = 0) out vec4 outColor;

void main() {
    vec3 n = normalize(inNormal);
    vec3 diffuse = color.xyz * texture(map, 3.0 * inUv).xyz * max(dot(n, light.xyz), 0.0);
    outColor = vec4(diffuse + 0.25 * textureLod(sky, n, 1.5).xyz, 1.0);
}
