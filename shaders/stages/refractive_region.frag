// refractive_region.frag: deferred shading of a solid of glass: its nearest front faces are the first layer of the interior
// G-buffer. Triangles of a fine mesh are a few pixels each: drawn forward, devices that shade blocks of pixels would shade most of
// them several times.
// Limits   no maps but of roughness and no colours of vertices: the layer holds depth, normal and alpha.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"

layout(binding = 31) uniform sampler2D hidingDepth; // of what is opaque and of glass that was drawn before and may hide this

layout(location = 0) out vec4 outColor; // premultiplied

// The outputs of opaque.vert.
vec3 inPosition;
vec3 inNormal;
const vec4 inTangent = vec4(0.0);
const vec4 inColor = vec4(1.0);
const vec4 inUv01 = vec4(0.0);
const vec4 inUv23 = vec4(0.0);

#include "stages/refractive.glsl"

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(interior, ivec3(at, 0), 0);
    float depth = uintBitsToFloat(texel.x);
    // Where the solid is not, or is hidden, the pixel keeps its colour. The depth test has left out most of these.
    bool shown = texel.w == objectId() && depth >= texelFetch(hidingDepth, at, 0).x;
    InteriorSurface s = interiorSurface(interiorCamera(), texel, at);
    inPosition = s.point;
    inNormal = s.n;
    layerAlpha = unpackHalf2x16(texel.z).x;
    vec4 color = refractiveColor(surfaceBaseColor());
    outColor = shown ? color : vec4(0.0);
}
