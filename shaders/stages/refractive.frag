// refractive.frag: a surface of glass: what it reflects, and what is seen through it.
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

#include "stages/surface.glsl"
#include "stages/object.glsl"
#include "stages/reflectance.glsl"
#include "stages/punctual_lights.glsl"
#include "stages/environment.glsl"
#include "stages/surroundings.glsl"
#include "stages/environment_light.glsl"
#include "stages/glass.glsl"
#include "stages/importance.glsl"
#include "stages/importance_glass.glsl"

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    float coverage = alphaMode == 2 ? base.w : 1.0;
    Surface s = readSurface(base);
    float through = s.transmission * (1.0 - s.metallic);
    // A base colour tints what passes once: its root at each face of a solid.
    bool twice = gl_FrontFacing || transmission == 1;
    vec3 tint = through * (twice ? s.baseColor : sqrt(s.baseColor));
    vec3 radiance = s.emissive;
    float ior = material.surface.w;
    WeightedBeam mirror = noBeam(s.position, s.n);
    if (hasEnvironment) {
        EnvironmentLight light = environmentLobe(s);
        LobeTap tap = mergedTap(s, light);
        mirror.beam = straightBeam(s.position, tap.direction, tap.sigma);
        mirror.weight = light.weight;
        radiance += light.diffuse;
    }
    if (indexIsOne) {
        radiance += tint * throughNothing();
    } else if (method == 0) {
        radiance += tint * throughStandard(s, ior) + mirror.weight * farRadiance(mirror.beam.direction, mirror.beam.sigma);
    } else {
        // Where the index depends on the wavelength each channel goes its own way.
        int ways = disperses ? 3 : 1;
        for (int k = 0; k < ways; ++k) {
            vec3 mask = vec3(1.0);
            if (disperses) mask = vec3(k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0);
            float own = disperses ? dispersedIor(ior, material.transmission.z, k) : ior;
            GlassBeams beams;
            if (twice) beams = throughTwoFaces(s, own);
            else beams = outOfSolid(s, own);
            beams.core.weight *= tint;
            beams.rest.weight *= tint;
            beams.bounced.weight *= tint;
            beams.leftOver.weight *= tint;
            if (method >= 100 && twice && !(beams.within >= 0.0)) {
                radiance += mask * tint * sampledGlass(s, own, beams, method - 100);
                beams.core.weight = vec3(0.0);
            }
            radiance += mask * glassRadiance(beams, mirror);
        }
    }
    if (hasLights) radiance += punctualLight(s);
    outColor = vec4(radiance * coverage, coverage);
}
