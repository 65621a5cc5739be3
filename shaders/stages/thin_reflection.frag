// thin_reflection.frag: reflection of a wall of no thickness, added to its transmission (thin_transmission.frag).
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

layout(location = 0) out vec4 outColor;

#include "stages/glass_material.glsl"
#include "stages/thin_wall.glsl"

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    float coverage = alphaMode == 2 ? base.w : 1.0;
    Surface s = readSurface(base);
    float ior = glassIor();
    vec3 tint = transmissionTint(s);
    float leaves = coatLeaves(s);
    ThinWallEnergy energy = wallEnergy(dot(s.wo, s.n), s.alpha, ior);
    vec3 radiance = leaves * s.emissive + coatOverGlass(s, tint * energy.transmitted);
    if (hasEnvironment) {
        EnvironmentLight light = environmentLobe(s);
        light.weight *= leaves;
        light.diffuse *= leaves;
        radiance += light.diffuse;
        MirrorLobes mirror = withReflectedLater(mirrorLobes(s, light), tint * energy.reflectedLater, ior);
        radiance += mirrorRadiance(mirror, tint * energy.transmitted);
    }
    if (hasLights) radiance += leaves * punctualLight(s);
    outColor = vec4(radiance * coverage, 0.0);
}
