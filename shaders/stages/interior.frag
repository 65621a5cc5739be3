// interior.frag: one layer of the surfaces of solids, for the search that follows rays inside (refraction/interior_fetch.glsl).
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/material.glsl"
#include "refraction/interior_fetch.glsl"
#include "stages/material_features.glsl"
#include "stages/object.glsl"

layout(constant_id = 53) const bool peels = false; // behind what `nearer` holds, else the nearest

layout(binding = 27) uniform usampler2D nearer; // the layer before this one, of the same facing

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;

layout(location = 0) out uvec4 outTexel;

#include "stages/surface.glsl"

void main() {
    // The same draw gives the same depth to the bit in every pass (opaque.vert: invariant).
    if (peels && gl_FragCoord.z >= uintBitsToFloat(texelFetch(nearer, ivec2(gl_FragCoord.xy), 0).x)) discard;
    Surface s = readSurface(surfaceBaseColor());
    float alpha = s.alpha; // coverage is not read from within
    if (!gl_FrontFacing && material.transmission.y >= 0.0) alpha = material.transmission.y;
    // Out of the solid on both its sides, and not turned to the viewer: rays inside come from elsewhere.
    vec3 n = surfaceNormal(true);
    outTexel = uvec4(floatBitsToUint(gl_FragCoord.z), packSnorm2x16(octEncode(n)), packHalf2x16(vec2(alpha, 0.0)), objectId());
    if (facesDiffer) {
        outTexel.z |= packInteriorTint(sqrt(s.baseColor));
        outTexel.w |= packInteriorClear(s.transmission * (1.0 - s.metallic));
    }
}
