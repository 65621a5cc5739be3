// light_arrival.glsl: direction and irradiance of punctual lights at a point (KHR_lights_punctual).
// Needs    interface/lights.glsl, interface/frame.glsl.
#include "stages/of_pixel.glsl"

struct Arrival {
    vec3 wi;         // unit, to the light
    vec3 irradiance; // across wi: lux, or candela / m²
    float range;     // metres to it
};

Arrival arrivalFrom(LightData light, vec3 position) {
    Arrival a;
    if (light.direction.w == 0.0) {
        a.wi = -light.direction.xyz;
        a.irradiance = light.intensity.xyz;
        a.range = 1e30;
        return a;
    }
    vec3 to = light.position.xyz - position;
    float d2 = dot(to, to);
    a.range = sqrt(d2);
    // At the light itself the inverse square has no value: 0.
    if (!(d2 > 0.0)) {
        a.wi = vec3(0.0, 0.0, 1.0);
        a.irradiance = vec3(0.0);
        return a;
    }
    a.wi = to * inversesqrt(d2);
    // "Range property": attenuation = saturate(1 - (d / range)^4) / d²; without a range the factor is 1.
    float part = d2 * light.position.w;
    a.irradiance = light.intensity.xyz * (clamp(1.0 - part * part, 0.0, 1.0) / d2);
    if (light.direction.w == 2.0) {
        float falloff = clamp(dot(light.direction.xyz, -a.wi) * light.cone.x + light.cone.y, 0.0, 1.0);
        a.irradiance *= falloff * falloff;
    }
    return a;
}
