// glass_look.glsl: reads the lobes that leave a solid of glass, for the passes that look them up.
// Needs    stages/glass_material.glsl.
#include "stages/glass_lobes.glsl"

layout(binding = 32) uniform sampler2D coreOrigin;
layout(binding = 33) uniform sampler2D coreShape;
layout(binding = 34) uniform sampler2D restOrigin;
layout(binding = 35) uniform sampler2D restShape;
layout(binding = 36) uniform sampler2D lobeWeight;

struct LobePair {
    WeightedLobe core;
    WeightedLobe rest;
};

LobePair readLobes() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 weight = texelFetch(lobeWeight, at, 0);
    LobePair pair;
    pair.core.lobe = unpackedLobe(texelFetch(coreOrigin, at, 0), texelFetch(coreShape, at, 0));
    pair.core.lobe.turn = turnOverPixel(pair.core.lobe.direction);
    pair.core.weight = (1.0 - weight.w) * weight.xyz;
    pair.rest = pair.core;
    if (entryLobes > 1) {
        pair.rest.lobe = unpackedLobe(texelFetch(restOrigin, at, 0), texelFetch(restShape, at, 0));
        pair.rest.lobe.turn = pair.core.lobe.turn;
        pair.rest.weight = weight.w * weight.xyz;
    }
    return pair;
}
