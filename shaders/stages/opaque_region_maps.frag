// opaque_region_maps.frag: deferred shading of surfaces whose maps have been read (geometry_maps.frag).
// Constants  as if there were no maps, no colours of vertices and no alpha.
#version 450
#include "stages/opaque_region.glsl"
#include "stages/packed_maps.glsl"

layout(binding = 29) uniform usampler2D geometryMaps;

layout(location = 0) out vec4 outColor;

void main() {
    readGeometry();
    MapValues maps = unpackedMaps(texelFetch(geometryMaps, ivec2(gl_FragCoord.xy), 0));
    Surface s = readSurface(vec4(maps.base, 1.0));
    s.metallic = maps.metal.x;
    if (!alphaIsGiven) s.alpha = maps.metal.y * maps.metal.y;
    s.occlusion = maps.occlusion;
    s.emissive = maps.emissive;
    outColor = vec4(opaqueRadiance(s), 1.0);
}
