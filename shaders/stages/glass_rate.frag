// glass_rate.frag: writes depth 1 where glass has to be shaded at every pixel, and the region's depth where fragments can be
// interpolated: the early depth test then selects the pixels. Whole quads, for derivatives.
#version 450
#include "interface/region.glsl"
#include "refraction/exit_surface.glsl"
#include "stages/glass_cells.glsl"

layout(binding = 26) uniform usampler2DArray interior;
layout(binding = 31) uniform sampler2D hidingDepth;
layout(binding = 36) uniform sampler2D glassCells;

void main() {
    ivec2 last = textureSize(interior, 0).xy - 1;
    bool alone = false;
    bool any = false;
    for (int k = 0; k < 4; ++k) {
        ivec2 at = min((ivec2(gl_FragCoord.xy) & ~1) + ivec2(k & 1, k >> 1), last);
        uvec4 texel = texelFetch(interior, ivec3(at, 0), 0);
        vec4 cell = texelFetch(glassCells, cellOf(at), 0);
        bool shown = float(texel.w) == region.back.z && uintBitsToFloat(texel.x) >= texelFetch(hidingDepth, at, 0).x;
        bool between = float(texel.w) == cell.z && dot(octDecode(unpackSnorm2x16(texel.y)), octDecode(cell.xy)) > CELL_LEAST_COS;
        any = any || shown;
        alone = alone || (shown && !between);
    }
    if (!any) discard;
    gl_FragDepth = alone ? 1.0 : region.back.x;
}
