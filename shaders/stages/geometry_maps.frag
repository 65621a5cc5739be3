// geometry_maps.frag: the G-buffer of surfaces that have maps or colours of vertices, and what these say there.
#version 450
#include "stages/geometry.glsl"
#include "stages/packed_maps.glsl"

layout(location = 1) out uvec4 outMaps;

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    outTexel = geometryTexel();
    outMaps = packedMaps(base.xyz, surfaceMetal(), surfaceOcclusion(), surfaceEmissive());
}
