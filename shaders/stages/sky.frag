// sky.frag: where nothing was drawn, the environment itself, unblurred unless that is asked for; or a plain colour.
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
    vec3 seen = frame.background.w > 0.0
        ? environmentRadiance(stackEven, stackOdd, frame.stack, inEnvironment(direction), frame.background.w)
        : environmentSharp(stackEven, frame.stack, inEnvironment(direction));
    outColor = vec4(frame.background.w < 0.0 ? frame.background.xyz : frame.environment.z * seen, 1.0);
}
