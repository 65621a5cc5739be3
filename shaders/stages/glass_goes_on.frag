// glass_goes_on.frag: gives the fragments whose light goes on inside by total reflection the depth 1: the depth test of the passes
// that follow it finds them.
#version 450

layout(binding = 32) uniform sampler2D firstPoint; // stages/glass_arrival.glsl

void main() {
    if (texelFetch(firstPoint, ivec2(gl_FragCoord.xy), 0).w >= 0.0) discard;
    gl_FragDepth = 1.0;
}
