// material_depth.frag: writes the depth of its material's region at each visible pixel of the G-buffer (geometry.frag), so that the
// early test for equal depth selects the pixels of a material. Those in cells whose corners agree (neighbour_cells.frag) have depths
// of their own.
#version 450
#include "interface/region.glsl"
#include "refraction/exit_surface.glsl"
#include "stages/packed_tangent.glsl"

layout(constant_id = 0) const bool hasCells = false;

layout(binding = 8) uniform usampler2D geometry;
layout(binding = 9) uniform sampler2D sceneDepth;
layout(binding = 10) uniform sampler2D neighbourCells;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(geometry, at, 0);
    bool seen = uintBitsToFloat(texel.x) == texelFetch(sceneDepth, at, 0).x;
    float number = float(unpackedNumber(texel.w));
    if (hasCells) {
        vec4 cell = texelFetch(neighbourCells, at / CELL_STEP, 0);
        vec3 n = octDecode(vec2(uintBitsToFloat(texel.y), uintBitsToFloat(texel.z)));
        if (cell.z > 0.0 && cell.z == number && dot(n, octDecode(cell.xy)) > CELL_COSINE) number += region.back.z;
    }
    gl_FragDepth = seen ? number * REGION_STEP : 0.0;
}
