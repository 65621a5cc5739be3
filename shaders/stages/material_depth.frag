// material_depth.frag: writes the depth of its material's region at each visible pixel of the G-buffer (geometry.frag), so that the
// early test for equal depth selects the pixels of a material.
#version 450
#include "interface/region.glsl"
#include "stages/packed_tangent.glsl"

layout(binding = 8) uniform usampler2D geometry;
layout(binding = 9) uniform sampler2D sceneDepth;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(geometry, at, 0);
    bool seen = uintBitsToFloat(texel.x) == texelFetch(sceneDepth, at, 0).x;
    gl_FragDepth = seen ? float(unpackedNumber(texel.w)) * REGION_STEP : 0.0;
}
