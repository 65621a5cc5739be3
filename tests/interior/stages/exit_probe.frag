// exit_probe.frag: what the search finds for one ray of smooth glass per pixel.
#version 450
#include "bsdf/reflection.glsl"
#include "bsdf/transmission.glsl"
#include "interface/frame.glsl"
#include "refraction/exit_search_fetch.glsl"

layout(constant_id = 0) const int pairs = 1;
layout(constant_id = 1) const int mostBounces = 2;
layout(constant_id = 2) const float ior = 1.5;
layout(constant_id = 3) const int shown = 0; // the segment that outFirst is about

layout(binding = 26) uniform usampler2DArray interior;

layout(location = 0) out vec4 outDirection; // xyz: after the last hit; w: bounces, -1: nothing found, -2: no glass, -3: too many
layout(location = 1) out vec4 outFirst;     // xyz: the first hit; w: places read along the whole way
layout(location = 2) out vec4 outRest;      // xy: curvature there; z: share found of the last; w: the thickness

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 front = texelFetch(interior, ivec3(at, INTERIOR_F1), 0);
    uvec4 back = texelFetch(interior, ivec3(at, INTERIOR_B1), 0);
    outDirection = vec4(0.0, 0.0, 0.0, -2.0);
    outFirst = vec4(0.0);
    outRest = vec4(0.0);
    // A camera inside sees a back face first: its rays start at the near plane, unbent.
    bool within = uintBitsToFloat(front.x) < uintBitsToFloat(back.x);
    if (!within && front.w == 0u) return;
    InteriorView view = interiorView(frame.clipFromWorld, frame.worldFromClip, vec2(textureSize(interior, 0).xy));
    float solid = float(within ? back.w : front.w);
    vec3 near = interiorWorld(view, gl_FragCoord.xy, 1.0);
    vec3 wo = frame.eye.w > 0.0 ? normalize(frame.eye.xyz - near) : -frame.viewDirection.xyz;
    InteriorSurface s = interiorSurface(view, front, at);
    vec3 point = within ? near : s.point;
    // As stages/surface.glsl: a normal that turns away from the viewer is turned back until it does not.
    float c = dot(s.n, wo);
    vec3 n = c >= 0.0 ? s.n : normalize(s.n - c * wo);
    vec3 d = within ? -wo : refractAbout(wo, n, ior);
    float guess = interiorThickness(interior, view, at, solid);
    outRest.w = guess;
    outDirection = vec4(d, -3.0);
    if (d == vec3(0.0)) { // nothing enters
        outDirection = vec4(reflectAbout(wo, n), -1.0);
        return;
    }
    for (int bounce = 0; bounce <= mostBounces; ++bounce) {
        ExitHit hit = findExit(interior, view, pairs, solid, point, d, guess, bounce > 0);
        outFirst.w += hit.reads;
        outRest.z = hit.found;
        if (bounce == shown) {
            outFirst.xyz = hit.point;
            outRest.xy = hit.curvature;
        }
        point = hit.point;
        if (hit.found == 0.0) {
            outDirection = vec4(d, -1.0);
            break;
        }
        vec3 outside = refractAbout(-d, hit.n, 1.0 / ior);
        if (outside != vec3(0.0)) {
            outDirection = vec4(outside, float(bounce));
            break;
        }
        d = reflectAbout(-d, hit.n);
        outDirection.xyz = d;
        guess = hit.distance;
    }
}
