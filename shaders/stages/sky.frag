// sky.frag: the environment itself where nothing was drawn, unblurred.
#version 450
#include "interface/frame.glsl"
#include "stages/environment.glsl"
#include "stages/of_pixel.glsl"

layout(location = 0) in vec2 inClip;
layout(location = 0) out vec4 outColor;

void main() {
    // Through the point of this pixel that lies on the near plane (reversed depth: 1).
    vec4 near = frame.worldFromClip * vec4(inClip, 1.0, 1.0);
    vec3 direction = ofPixel(frame.eye.w) > 0.0 ? near.xyz / near.w - frame.eye.xyz : frame.viewDirection.xyz;
    outColor = vec4(frame.environment.z * environmentSharp(stackEven, frame.stack, inEnvironment(direction)), 1.0);
}
