// punctual_lights.glsl: a surface's radiance under punctual lights.
// Needs    stages/reflectance.glsl, stages/neighbours.glsl.
#include "interface/shadows.glsl"
#include "stages/shadow_maps.glsl"

// The share of a light that reaches a point past occluders. n: of the mesh there.
vec3 lightPasses(LightData light, Arrival a, vec3 p, vec3 n) {
    bool mapped = false;
    vec3 passed = vec3(1.0);
    if (lighting > 1) {
        mapped = light.cone.w != 0.0;
        if (light.cone.w > 0.0) passed = passesShadowMaps(light, p, n, a.wi);
    }
    if (neighbourKinds != 0) {
        // A point of light: as sharp as shares are.
        if (!mapped) passed = passesNeighbours(p, a.wi, a.range, 0.0);
        else if (spheresAround && glassAround) passed *= passesLenses(p, a.wi, a.range);
    }
    return passed;
}

vec3 punctualLight(Surface s) {
    vec3 sum = vec3(0.0);
    vec3 meshNormal = unitNormal(inNormal, gl_FrontFacing);
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], s.position);
        vec3 light = a.irradiance * materialFCos(s, a.wi);
        if (neighbourKinds != 0 || lighting > 1) {
            // The side that the light comes to: of what passes diffuse light it may be the other one.
            vec3 n = passesDiffuse && dot(meshNormal, a.wi) < 0.0 ? -meshNormal : meshNormal;
            if (ofPixel(light.x + light.y + light.z) > 0.0) light *= lightPasses(lights[i], a, s.position, n);
        }
        sum += light;
    }
    return sum;
}
