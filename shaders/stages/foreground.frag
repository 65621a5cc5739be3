// foreground.frag: depth only, or transparent black: cuts an opaque body out of the colour that a layer of glass behind it looks
// up.
#version 450
#include "interface/material.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;

layout(location = 0) out vec4 outColor;

#include "interface/frame.glsl"
#include "stages/surface.glsl"

void main() {
    if (alphaMode == 1 && surfaceBaseColor().w < material.emissive.w) discard;
    outColor = vec4(0.0);
}
