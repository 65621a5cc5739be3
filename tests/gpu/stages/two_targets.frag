#version 450
layout(location = 0) in vec2 inUv;
layout(location = 0) out vec4 outFirst;
layout(location = 1) out uvec2 outSecond;

void main() {
    outFirst = vec4(inUv, 0.25, 1.0);
    outSecond = uvec2(gl_FragCoord.xy);
}
