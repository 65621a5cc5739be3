// neighbour_light.frag: what neighbours add, at the corners of cells.
// Writes   the irradiance, w the number of the region; the sum of the reflection lobes, w the first one's sigma; by which factors the
//          surface sends these, and all that it sends of the environment's light.
#version 450
#include "interface/frame.glsl"
#include "interface/region.glsl"
#include "stages/corner_pixel.glsl"
#include "stages/opaque_region.glsl"

layout(location = 0) out vec4 outIrradiance;
layout(location = 1) out vec4 outReflected;
layout(location = 2) out vec4 outSent;

void main() {
    Surface s = regionSurface();
    EnvironmentLight light = environmentLobe(s);
    vec3 far = farLobes(s, light);
    vec3 reflected = reflectedLight(s, light);
    vec3 irradiance = vec3(0.0);
    if (takesIrradiance) irradiance = light.around - wideRadiance(s.n);
    outIrradiance = vec4(irradiance, region.back.x / REGION_STEP);
    outReflected = vec4(reflected - far, sqrt(light.lobe.sigma * light.lobe.sigma + s.turn));
    outSent = vec4(s.occlusion * meanOf(light.base), meanOf(light.weight), meanOf(light.diffuse + light.weight * reflected), 0.0);
}
