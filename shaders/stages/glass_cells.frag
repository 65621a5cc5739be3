// glass_cells.frag: whether the values of four fragments of glass_footprint.glsl can be interpolated.
// Writes   xy the mean normal (octEncode), z the number of the solid; 0 where they do not agree.
// Form     second differences along each side of the cell, with the fragments beyond both ends. The error of interpolation is an
//          eighth of that where values are smooth, half where they jump. Where a side has no fragment beyond an end: the first
//          difference.
#version 450
#include "refraction/exit_surface.glsl"
#include "stages/glass_cells.glsl"

layout(binding = 26) uniform usampler2DArray interior;
layout(binding = 32) uniform sampler2D glassOffsets;
layout(binding = 33) uniform sampler2D glassSpots;
layout(binding = 34) uniform sampler2D glassLobes;
layout(binding = 35) uniform sampler2D glassFar;

layout(location = 0) out vec4 outCell;

// The most that a second difference may be.
const float MOST_SHARE = 0.1;     // of the lobes' weight: their shares
const float MOST_WEIGHT = 0.1;    // of itself: the weight; of all radiance: the far one
const float MOST_PIXELS = 1.0;    // of offsets and sigmas, where a spot is sharp,
const float MOST_SIGMAS = 0.5;    // and of its sigma where it is wide
const float NOT_SEEN = 0.004;     // a share, or a weight: a step of 8 bits

struct Fragment {
    vec4 offsets;
    vec4 spots; // sigmas
    vec4 lobes;
    vec3 far;
    float near;
};

Fragment fragmentAt(ivec2 at) {
    ivec2 inside = clamp(at, ivec2(0), textureSize(glassLobes, 0) - 1);
    Fragment f;
    f.offsets = texelFetch(glassOffsets, inside, 0);
    f.spots = texelFetch(glassSpots, inside, 0);
    f.spots.xy = sqrt(f.spots.xy);
    f.lobes = texelFetch(glassLobes, inside, 0);
    vec4 light = texelFetch(glassFar, inside, 0);
    f.far = light.xyz;
    f.near = light.w;
    return f;
}

bool bendsLittle(Fragment a, Fragment b, Fragment c, bool hasThird) {
    // Without a third one it is as if it were the second.
    vec4 spots = a.spots - 2.0 * b.spots + c.spots;
    vec4 offsets = a.offsets - 2.0 * b.offsets + c.offsets;
    vec3 lobes = a.lobes.xyz - 2.0 * b.lobes.xyz + c.lobes.xyz;
    vec3 far = a.far - 2.0 * b.far + c.far;
    if (!hasThird) {
        spots = a.spots - b.spots;
        offsets = a.offsets - b.offsets;
        lobes = a.lobes.xyz - b.lobes.xyz;
        far = a.far - b.far;
    }
    vec2 most = MOST_PIXELS + MOST_SIGMAS * min(a.spots.xy, b.spots.xy);
    vec2 share = max(a.spots.zw, b.spots.zw);
    bvec2 placed = lessThanEqual(max(max(abs(offsets.xz), abs(offsets.yw)), abs(spots.xy)), most);
    return all(lessThanEqual(abs(spots.zw), vec2(MOST_SHARE))) && (placed.x || share.x < NOT_SEEN) && (placed.y || share.y < NOT_SEEN) &&
           all(lessThanEqual(abs(lobes), MOST_WEIGHT * b.lobes.xyz + NOT_SEEN)) && all(lessThanEqual(abs(far), MOST_WEIGHT * (b.far + b.near)));
}

// Between the second and the third of four fragments in a row.
bool sideAgrees(ivec2 second, ivec2 step, float solid) {
    Fragment a = fragmentAt(second - step);
    Fragment b = fragmentAt(second);
    Fragment c = fragmentAt(second + step);
    Fragment d = fragmentAt(second + 2 * step);
    return bendsLittle(c, b, a, a.lobes.w == solid) && bendsLittle(b, c, d, d.lobes.w == solid);
}

void main() {
    ivec2 last = textureSize(glassLobes, 0) - 1;
    ivec2 low = ivec2(gl_FragCoord.xy) - 1;
    float solid = fragmentAt(low).lobes.w;
    bool agrees = solid > 0.0;
    vec3 normals[4];
    vec3 mean = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 at = clamp(low + ivec2(k & 1, k >> 1), ivec2(0), last);
        agrees = agrees && fragmentAt(at).lobes.w == solid;
        ivec2 pixel = min(pixelOfFragment(at), textureSize(interior, 0).xy - 1);
        normals[k] = octDecode(unpackSnorm2x16(texelFetch(interior, ivec3(pixel, 0), 0).y));
        mean += normals[k];
    }
    mean = normalize(mean);
    for (int k = 0; k < 4; ++k) {
        ivec2 step = (k & 1) == 0 ? ivec2(1, 0) : ivec2(0, 1);
        agrees = agrees && dot(normals[k], mean) > CELL_LEAST_COS && sideAgrees(low + (k >> 1) * (1 - step), step, solid);
    }
    outCell = agrees ? vec4(octEncode(mean), solid, 0.0) : vec4(0.0);
}
