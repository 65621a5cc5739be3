// opaque_region.glsl: reads the G-buffer (geometry.glsl) for deferred shading [Deering88] of the opaque surfaces of one material
// (material_depth.frag). Triangles of a fine mesh are smaller than the blocks of pixels that devices shade: drawn forward, most
// pixels would be shaded several times.
#include "interface/frame.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "refraction/exit_surface.glsl"
#include "stages/material_features.glsl"
#include "stages/packed_tangent.glsl"

layout(binding = 28) uniform usampler2D geometry;

// The outputs of opaque.vert.
vec3 inPosition;
vec3 inNormal;
vec4 inTangent;
const vec4 inColor = vec4(1.0);
const vec4 inUv01 = vec4(0.0);
const vec4 inUv23 = vec4(0.0);
float inHollow;

#include "stages/opaque.glsl"

void readGeometry() {
    uvec4 texel = texelFetch(geometry, ivec2(gl_FragCoord.xy), 0);
    InteriorView view = interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy);
    inPosition = interiorWorld(view, gl_FragCoord.xy, uintBitsToFloat(texel.x));
    inNormal = octDecode(vec2(uintBitsToFloat(texel.y), uintBitsToFloat(texel.z))); // on the viewer's side already
    inTangent = vec4(0.0);
    inHollow = 0.0;
    if (hasHollows) inHollow = float(texel.w & 4095u) / 4095.0;
    if (brushedLobes > 0) inTangent = unpackedTangent(texel.w, inNormal);
}
