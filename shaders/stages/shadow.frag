// shadow.frag: depth of shadow casters in a light's view.
#version 450
#include "interface/frame.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;

#include "stages/surface.glsl"

void main() {
    if (alphaMode == 1 && surfaceBaseColor().w < material.emissive.w) discard;
}
