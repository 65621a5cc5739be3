// picked_outline.frag: 1 beside what is picked, within the outline's width.
#version 450

layout(std140, binding = 0) uniform Outline {
    vec4 outline; // x, y: size of the mask, pixels; z: width of the outline, pixels of the mask
};
layout(binding = 1) uniform sampler2D pickedMask;

layout(location = 0) out vec4 outEdge;

void main() {
    vec2 at = gl_FragCoord.xy / outline.xy;
    vec2 straight = outline.z / outline.xy, slanted = 0.70710678 * straight;
    float near = 0.0;
    for (int i = -1; i < 2; i += 2) {
        float side = float(i);
        near = max(near, textureLod(pickedMask, at + vec2(side * straight.x, 0.0), 0.0).x);
        near = max(near, textureLod(pickedMask, at + vec2(0.0, side * straight.y), 0.0).x);
        near = max(near, textureLod(pickedMask, at + side * slanted, 0.0).x);
        near = max(near, textureLod(pickedMask, at + side * vec2(slanted.x, -slanted.y), 0.0).x);
    }
    outEdge = vec4(textureLod(pickedMask, at, 0.0).x > 0.5 ? 0.0 : near);
}
