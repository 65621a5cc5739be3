// geometry.glsl: what the shading of an opaque surface takes from its mesh, for opaque_region.frag: a G-buffer [SaitoTakahashi90].
// A texel: x bits of the depth; y, z of the normal's octahedron, which needs the digits that interpolation gives: a mirror shows
// a thousandth of a degree; w the number of the region of its material, 0 where there is nothing, and its tangent if it is brushed.
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
layout(location = 6) in float inHollow;

layout(location = 0) out uvec4 outTexel;

#include "stages/packed_tangent.glsl"
#include "stages/surface.glsl"

uvec4 geometryTexel() {
    vec2 n = octEncode(surfaceNormal(gl_FrontFacing));
    uint number = uint(region.back.x / REGION_STEP);
    uint bits = packedNumber(number);
    // The bitangent is that of the mesh's own normal, which a back face's is turned against.
    if (hasHollows) bits |= uint(clamp(inHollow, 0.0, 1.0) * 4095.0 + 0.5);
    if (brushedLobes > 0) bits |= packedTangent(octDecode(n), vec4(inTangent.xyz, gl_FrontFacing ? inTangent.w : -inTangent.w));
    return uvec4(floatBitsToUint(gl_FragCoord.z), floatBitsToUint(n.x), floatBitsToUint(n.y), bits);
}
