// glass_resolve.frag: glass between the fragments of glass_footprint.glsl: its lobes looked up at every pixel.
#version 450
#include "interface/frame.glsl"
#include "refraction/screen_pyramid_fetch.glsl"
#include "stages/glass_cells.glsl"

layout(binding = 24) uniform sampler2D screenPyramid;
layout(binding = 26) uniform usampler2DArray interior;
layout(binding = 31) uniform sampler2D hidingDepth;
layout(binding = 32) uniform sampler2D glassOffsets;
layout(binding = 33) uniform sampler2D glassSpots;
layout(binding = 34) uniform sampler2D glassLobes;
layout(binding = 35) uniform sampler2D glassFar;
layout(binding = 36) uniform sampler2D glassCells;

layout(location = 0) out vec4 outColor;

vec3 lookedUp(vec2 at, float variance) {
    vec4 seen = fetchPyramid(screenPyramid, at, frame.picture.xy, variance, frame.picture.w);
    return seen.w > 0.0 ? seen.xyz / seen.w : vec3(0.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(interior, ivec3(pixel, 0), 0);
    float solid = texelFetch(glassCells, cellOf(pixel), 0).z;
    outColor = vec4(0.0);
    if (!(solid > 0.0 && float(texel.w) == solid && uintBitsToFloat(texel.x) >= texelFetch(hidingDepth, pixel, 0).x)) return;
    vec2 at = ((vec2(pixel) - float(apart / 2)) / float(apart) + 0.5) / vec2(textureSize(glassLobes, 0));
    vec4 offsets = textureLod(glassOffsets, at, 0.0);
    vec4 spots = textureLod(glassSpots, at, 0.0);
    vec3 lobes = textureLod(glassLobes, at, 0.0).xyz;
    vec3 sum = textureLod(glassFar, at, 0.0).xyz;
    vec2 centre = vec2(pixel) + 0.5;
    sum += lobes * spots.z * lookedUp(centre + offsets.xy, spots.x);
    if (spots.w > 0.0) sum += lobes * spots.w * lookedUp(centre + offsets.zw, spots.y);
    outColor = vec4(sum, 1.0);
}
