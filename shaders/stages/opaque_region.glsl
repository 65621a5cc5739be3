// opaque_region.glsl: reads the G-buffer (geometry.glsl) for deferred shading [Deering88] of the opaque surfaces of one material
// (material_depth.frag). Triangles of a fine mesh are smaller than the blocks of pixels that devices shade: drawn forward, most
// pixels would be shaded several times.
// Constants as if there were no maps, no colours of vertices and no alpha: what they say has been read (geometry_maps.frag).
#include "interface/frame.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "refraction/exit_surface.glsl"
#include "stages/material_features.glsl"
#include "stages/packed_maps.glsl"
#include "stages/packed_tangent.glsl"
#include "stages/picture_pixel.glsl"

layout(constant_id = 56) const bool keepsMaps = false;
layout(binding = 28) uniform usampler2D geometry;
layout(binding = 29) uniform usampler2D geometryMaps;

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
    uvec4 texel = texelFetch(geometry, picturePixel(), 0);
    InteriorView view = interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy);
    inPosition = interiorWorld(view, vec2(picturePixel()) + 0.5, uintBitsToFloat(texel.x));
    inNormal = octDecode(vec2(uintBitsToFloat(texel.y), uintBitsToFloat(texel.z))); // on the viewer's side already
    inTangent = vec4(0.0);
    inHollow = 0.0;
    if (hasHollows) inHollow = float(texel.w & 4095u) / 4095.0;
    if (brushedLobes > 0) inTangent = unpackedTangent(texel.w, inNormal);
}

Surface regionSurface() {
    readGeometry();
    if (!keepsMaps) return readSurface(surfaceBaseColor());
    MapValues maps = unpackedMaps(texelFetch(geometryMaps, picturePixel(), 0));
    Surface s = readSurface(vec4(maps.base, 1.0));
    s.metallic = maps.metal.x;
    if (!alphaIsGiven) s.alpha = maps.metal.y * maps.metal.y;
    s.occlusion = maps.occlusion;
    s.emissive = maps.emissive;
    return s;
}
