// opaque.frag: what an opaque (or masked, or blended) surface sends to the viewer, as linear radiance.
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

layout(location = 0) out vec4 outColor; // premultiplied where blended

#include "stages/surface.glsl"
#include "stages/reflectance.glsl"
#include "stages/punctual_lights.glsl"
#include "stages/environment.glsl"
#include "stages/surroundings.glsl"
#include "stages/environment_light.glsl"
#include "stages/importance.glsl"

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    float coverage = alphaMode == 2 ? base.w : 1.0;
    if (shading == 0) {
        outColor = vec4(base.xyz * coverage, coverage);
        return;
    }
    Surface s = readSurface(base);
    vec3 radiance = s.emissive;
    if (hasEnvironment) {
        if (method >= 100) radiance += sampledLight(s, method - 100);
        else radiance += environmentLight(s);
    }
    if (hasLights) radiance += punctualLight(s);
    outColor = vec4(radiance * coverage, coverage);
}
