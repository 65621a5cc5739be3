// geometry.frag: what the shading of an opaque surface takes from its mesh, for opaque_region.frag: a G-buffer [SaitoTakahashi90].
// A texel: x bits of the depth; y, z of the normal's octahedron, which needs the digits that interpolation gives: a mirror shows
// a thousandth of a degree; w of the depth by which the region of its material finds it, 0 where there is nothing.
#version 450
#include "interface/frame.glsl"
#include "interface/material.glsl"
#include "interface/region.glsl"
#include "refraction/exit_surface.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;

layout(location = 0) out uvec4 outTexel;

#include "stages/surface.glsl"

void main() {
    vec2 n = octEncode(surfaceNormal(gl_FrontFacing));
    outTexel = uvec4(floatBitsToUint(gl_FragCoord.z), floatBitsToUint(n.x), floatBitsToUint(n.y), floatBitsToUint(region.back.x));
}
