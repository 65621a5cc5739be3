// opaque.glsl: radiance of an opaque (or masked, or blended) surface towards the viewer.
// Frame    world, metres.
// Needs    interface/{frame,lights,material}.glsl, stages/material_features.glsl, the inputs of opaque.vert.
// Returns  linear radiance; opaqueColor: premultiplied by the coverage in w. base: surfaceBaseColor().
#include "stages/surface.glsl"
#include "stages/reflectance.glsl"
#include "stages/environment.glsl"
#include "stages/neighbours.glsl"
#include "stages/punctual_lights.glsl"
#include "stages/surroundings.glsl"
#include "stages/environment_light.glsl"
#include "stages/importance.glsl"
#include "stages/clearcoat.glsl"

vec3 opaqueRadiance(Surface s) {
    if (hasHollows) s.hollow = clamp(inHollow, 0.0, 1.0);
    vec3 radiance = s.emissive;
    if (gathersLight) {
        if (method >= 100) radiance += sampledLight(s, method - 100);
        else radiance += environmentLight(s);
    }
    if (hasLights) radiance += punctualLight(s);
    return coated(s, radiance);
}

vec4 opaqueColor(vec4 base) {
    float coverage = alphaMode == 2 ? base.w : 1.0;
    vec3 radiance = base.xyz;
    if (shading != 0) radiance = opaqueRadiance(readSurface(base));
    return vec4(radiance * coverage, coverage);
}
