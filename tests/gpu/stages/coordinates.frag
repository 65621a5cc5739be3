#version 450
// Where the fragment is, and how that changes to the right and down.
layout(location = 0) in vec2 inUv;
layout(location = 0) out vec4 outColor;

void main() {
    outColor = vec4(gl_FragCoord.xy, dFdx(inUv.x), dFdy(inUv.y));
}
