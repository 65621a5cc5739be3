// neighbour_corners.frag: material_depth.frag at the corners of cells.
#version 450
#include "interface/frame.glsl"
#include "interface/region.glsl"
#include "stages/corner_pixel.glsl"
#include "stages/packed_tangent.glsl"

layout(binding = 8) uniform usampler2D geometry;
layout(binding = 9) uniform sampler2D sceneDepth;

void main() {
    ivec2 at = picturePixel();
    uvec4 texel = texelFetch(geometry, at, 0);
    bool seen = uintBitsToFloat(texel.x) == texelFetch(sceneDepth, at, 0).x;
    gl_FragDepth = seen ? float(unpackedNumber(texel.w)) * REGION_STEP : 0.0;
}
