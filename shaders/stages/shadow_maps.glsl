// shadow_maps.glsl: the share of a light's rays that reaches a point, by shadow maps.
// Frame    world, metres; directions unit.
// Needs    interface/lights.glsl, interface/shadows.glsl, stages/material_features.glsl.
// Source   percentage-closer filtering [Reeves87], by a quadratic B-spline over 3 x 3 texels: punctual lights have no size, and
//          three texels are about one pixel and a half. Each texel is compared with the depth of the surface's own plane there, so
//          that a plane never shadows itself and shadows begin where things touch.
// Limits   a place in front of some glass and behind other is tinted by both.
#include "bsdf/constants.glsl"

layout(binding = 48) uniform sampler2DArray shadowDepth;
layout(binding = 49) uniform sampler2DArray shadowGlassDepth;
layout(binding = 50) uniform sampler2DArray shadowTint;

const bool shadowsAreTinted = lighting == 3;

// Cosine between the plane and the light, at least: over the filter's reach of 1.5 texels a steeper plane is 15 texels deep, more
// than curved surfaces are flat over; at that angle a tenth of the light arrives.
const float STEEPEST = 0.1;
// Texels along the normal by which a surface is raised: meshes' normals are off their triangles by a few degrees (.05 radians at a
// slope of 10 times 1.5 texels is .5 / cosine).
const float RAISED = 0.5;

struct MapPlace {
    int layer;
    ivec2 texel; // in the middle of the filter
    vec2 off;    // of the place from that texel's centre, -.5 to .5
    float depth; // there
    vec2 slope;  // of the surface's plane, per texel
    bool inside; // of the map
};

// Which face of a cube: its views lie +X -X +Y -Y +Z -Z.
int cubeFace(vec3 d) {
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0 : 1;
    if (a.y >= a.z) return d.y > 0.0 ? 2 : 3;
    return d.z > 0.0 ? 4 : 5;
}

MapPlace placeOnMap(int layer, vec3 p, vec3 n, vec3 wi) {
    ShadowViewData view = shadows.views[layer];
    vec4 clip = view.clipFromWorld * vec4(p, 1.0);
    float c = dot(n, wi);
    vec3 raised = p + (RAISED * view.texel.x * clip.w) * n;
    vec3 facing = n;
    if (c < STEEPEST) {
        vec3 level = n - c * wi;
        facing = STEEPEST * wi + sqrt(1.0 - STEEPEST * STEEPEST) * level * inversesqrt(max(dot(level, level), LEAST_LENGTH2));
    }
    clip = view.clipFromWorld * vec4(raised, 1.0);
    vec3 at = clip.xyz / max(clip.w, LEAST_DIVISOR);
    // A plane stays one in clip coordinates.
    vec4 plane = vec4(facing, -dot(facing, raised)) * view.worldFromClip;
    float size = view.texel.y;
    MapPlace place;
    place.layer = layer;
    place.slope = vec2(-plane.x, plane.y) * (2.0 / (size * plane.z));
    vec2 texels = vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * size - 0.5;
    place.texel = ivec2(floor(texels + 0.5));
    place.off = texels - vec2(place.texel);
    place.depth = at.z;
    place.inside = clip.w > 0.0 && max(abs(at.x), abs(at.y)) < 1.0;
    return place;
}

// Of the light that comes along the rays of a map to the place.
vec3 passesMap(MapPlace place) {
    if (!place.inside) return vec3(1.0);
    vec2 f = place.off;
    vec3 wx = vec3(0.5 * (0.5 - f.x) * (0.5 - f.x), 0.75 - f.x * f.x, 0.5 * (0.5 + f.x) * (0.5 + f.x));
    vec3 wy = vec3(0.5 * (0.5 - f.y) * (0.5 - f.y), 0.75 - f.y * f.y, 0.5 * (0.5 + f.y) * (0.5 + f.y));
    int last = textureSize(shadowDepth, 0).x - 1;
    vec3 sum = vec3(0.0);
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            ivec3 texel = ivec3(clamp(place.texel + ivec2(i, j), ivec2(0), ivec2(last)), place.layer);
            float own = place.depth + dot(place.slope, vec2(float(i), float(j)) - f);
            if (texelFetch(shadowDepth, texel, 0).x > own) continue;
            float weight = wx[i + 1] * wy[j + 1];
            vec3 tint = vec3(1.0);
            if (shadowsAreTinted) {
                if (texelFetch(shadowGlassDepth, texel, 0).x > own) tint = min(exp(-texelFetch(shadowTint, texel, 0).xyz), vec3(1.0));
            }
            sum += weight * tint;
        }
    return sum;
}

// Of a light that has views.
vec3 passesShadowMaps(LightData light, vec3 p, vec3 n, vec3 wi) {
    int layer = int(light.cone.z);
    if (light.cone.w > 1.0) layer += cubeFace(-wi);
    return passesMap(placeOnMap(layer, p, n, wi));
}
