// glass_lobes.glsl: the two lobes that leave a solid of glass where its light first comes to a face, as data between its passes.
// Layout   per pixel, floats of 32 bits (places are seen from far, directions by what they meet):
//          coreOrigin xyz world, metres; w offset (LobeRay)
//          coreShape  xy direction (octEncode); z sigma; w carried, radians
//          restOrigin, restShape: the other lobe, the same
//          lobeWeight rgb of both together; w the share of the second
// Needs    stages/weighted_lobes.glsl, refraction/exit_surface.glsl.
#include "bsdf/constants.glsl"

layout(binding = 39) uniform sampler2D endWithin; // stages/glass_within.glsl

float endWithinGlass() { return holdsOpaque ? texelFetch(endWithin, ivec2(gl_FragCoord.xy), 0).x : -1.0; }

vec4 packedOrigin(LobeRay lobe) { return vec4(lobe.origin, lobe.inside * lobe.inner); }

vec4 packedShape(LobeRay lobe) { return vec4(octEncode(lobe.direction), lobe.sigma, lobe.carried); }

vec4 packedWeight(WeightedLobe core, WeightedLobe rest) {
    vec3 both = core.weight + rest.weight;
    return vec4(both, largest(rest.weight) / max(largest(both), LEAST_DIVISOR));
}

// Offsets scale with the way inside: stored as if that were a metre.
LobeRay unpackedLobe(vec4 origin, vec4 shape) {
    LobeRay lobe = lobeRay(origin.xyz, octDecode(shape.xy), shape.z);
    lobe.inner = origin.w;
    lobe.inside = 1.0;
    lobe.carried = shape.w;
    return lobe;
}
