// backdrop.frag: the picture behind a layer of glass, for its lookups: level 0 of the screen pyramid, and depth.
#version 450
#include "interface/layer.glsl"

layout(binding = 8) uniform sampler2D sceneColor;
layout(binding = 9) uniform sampler2D sceneDepth;

layout(location = 0) out vec4 outColor; // premultiplied by whether it can be behind the layer
layout(location = 1) out float outDepth;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(sceneDepth, at, 0).x;
    float behind = depth <= layer.backdrop.x ? 1.0 : 0.0;
    outColor = behind * vec4(texelFetch(sceneColor, at, 0).xyz, 1.0);
    outDepth = depth;
}
