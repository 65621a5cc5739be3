// thin_transmission.frag: transmission of a wall of no thickness. thin_reflection.frag adds its reflection.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;

layout(location = 0) out vec4 outColor; // premultiplied

#include "stages/glass_material.glsl"
#include "stages/thin_wall.glsl"

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    float coverage = alphaMode == 2 ? base.w : 1.0;
    Surface s = readSurface(base);
    ThinWall wall = throughThinWall(s, glassIor());
    WeightedLobe core = seenThrough(wall.through.core, transmissionTint(s));
    WeightedLobe rest = wall.through.rest;
    rest.lobe.turn = core.lobe.turn;
    rest.weight *= transmissionTint(s);
    GlassLookup g = lookupOf(core);
    g.rest = rest;
    g.both = entryLobes > 1;
    g.transmitted = true;
    outColor = vec4(lookupRadiance(g) * coverage, coverage);
}
