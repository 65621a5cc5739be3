// opaque.frag: an opaque (or masked, or blended) surface, by its triangles.
#version 450
#include "interface/frame.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;
layout(location = 6) in float inHollow;

layout(location = 0) out vec4 outColor; // premultiplied where blended

#include "stages/opaque.glsl"

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    outColor = opaqueColor(base);
}
