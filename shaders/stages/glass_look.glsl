// glass_look.glsl: the lobes that leave a solid of glass, as the passes that look them up read them.
// Needs    stages/glass_material.glsl.
#include "stages/glass_lobes.glsl"

layout(binding = 32) uniform sampler2D coreOrigin;
layout(binding = 33) uniform sampler2D coreShape;
layout(binding = 34) uniform sampler2D restOrigin;
layout(binding = 35) uniform sampler2D restShape;
layout(binding = 36) uniform sampler2D lobeWeight;

struct LobePair {
    WeightedBeam core;
    WeightedBeam rest;
};

LobePair readLobes() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 weight = texelFetch(lobeWeight, at, 0);
    LobePair pair;
    pair.core.beam = unpackedBeam(texelFetch(coreOrigin, at, 0), texelFetch(coreShape, at, 0));
    pair.core.beam.turn = turnOverPixel(pair.core.beam.direction);
    pair.core.weight = (1.0 - weight.w) * weight.xyz;
    pair.rest = pair.core;
    if (entryTaps > 1) {
        pair.rest.beam = unpackedBeam(texelFetch(restOrigin, at, 0), texelFetch(restShape, at, 0));
        pair.rest.beam.turn = pair.core.beam.turn;
        pair.rest.weight = weight.w * weight.xyz;
    }
    return pair;
}
