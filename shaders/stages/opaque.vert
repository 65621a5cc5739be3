// opaque.vert: a mesh into the picture, with what the surface needs in world space.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent; // w: the sign of the bitangent
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec2 inUv0; // the sets that the material's maps read, in the order of needs/features.h
layout(location = 5) in vec2 inUv1;
layout(location = 6) in vec2 inUv2;
layout(location = 7) in vec2 inUv3;
layout(location = 8) in float inHollow;

layout(location = 0) out vec3 outPosition; // world, metres
layout(location = 1) out vec3 outNormal;   // world, unit at the corners, length left to interpolation
layout(location = 2) out vec4 outTangent;
layout(location = 3) out vec4 outColor;
layout(location = 4) out vec4 outUv01;
layout(location = 5) out vec4 outUv23;
layout(location = 6) out float outHollow; // share of the cosine lobe about the normal that meets the mesh itself

invariant gl_Position; // passes that draw the same draw compare depths to the bit (interior.frag)

// MikkTSpace's basis is unit at the corners: a scaled instance must not flatten or steepen its normal map.
vec3 unitOrZero(vec3 v) {
    float s = dot(v, v);
    return s > 0.0 ? v * inversesqrt(s) : v;
}

void main() {
    vec4 position = instance.worldFromMesh * vec4(inPosition, 1.0);
    gl_Position = frame.clipFromWorld * position;
    outPosition = position.xyz;
    outNormal = unitOrZero(mat3(instance.normalFromMesh) * inNormal);
    // What no map reads is neither fetched nor transformed.
    outTangent = vec4(0.0);
    if (normalMapUv > 0 || clearcoatNormalMapUv > 0 || brushing > 0)
        outTangent = vec4(unitOrZero(mat3(instance.worldFromMesh) * inTangent.xyz), inTangent.w * instance.normalFromMesh[3][3]);
    outColor = vec4(1.0);
    if (hasVertexColor) outColor = inColor;
    outHollow = 0.0;
    if (hasHollows) outHollow = inHollow;
    outUv01 = vec4(0.0);
    outUv23 = vec4(0.0);
    if (uvSets > 0) outUv01.xy = inUv0;
    if (uvSets > 1) outUv01.zw = inUv1;
    if (uvSets > 2) outUv23.xy = inUv2;
    if (uvSets > 3) outUv23.zw = inUv3;
}
