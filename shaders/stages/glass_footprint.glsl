// glass_footprint.glsl: the footprints on the picture of the lobes that leave a solid of glass, for glass_resolve.frag, which does
// their lookups at every pixel.
// Layout   floats of 32 bits: places are looked up within a fraction of a pixel, radiance exceeds half floats.
//          offsets  xy of core, zw of rest, pixels from the fragment's own
//          spots    xy variances of both, pixels²; zw the shares of lobeColor that the picture covers
//          lobes    rgb weight of both together; w the number of the solid (stages/object.glsl), 0 where there is none
//          far      rgb radiance that does not come from the picture, or comes by strata of a wide lobe; w the largest channel of
//                   what the picture covers
#include "bsdf/constants.glsl"
#include "stages/glass_material.glsl"
#include "stages/glass_look.glsl"

layout(location = 0) out vec4 outOffsets;
layout(location = 1) out vec4 outSpots;
layout(location = 2) out vec4 outLobes;
layout(location = 3) out vec4 outFar;

void writeFootprint() {
    LobePair pair = readLobes();
    float within = endWithinGlass();
    vec3 both = pair.core.weight + pair.rest.weight;
    if (entryLobes == 1) both = pair.core.weight;
    outOffsets = vec4(0.0);
    outSpots = vec4(0.0);
    outLobes = vec4(both, float(objectId()));
    outFar = vec4(0.0);
    // As lookupRadiance(). What strata bring is interpolated as radiance: it changes slowly.
    vec4 strata = vec4(0.0);
    float wide = 0.0;
    int last = 0;
    for (int k = 0; k <= last; ++k) {
        vec3 stratum = stratumAt(k);
        Intersection intersection = lobeIntersection(stratumOf(pair.core.lobe, stratum), within);
        if (k == 0 && within < 0.0) wide = wideShare(pair.core.lobe, intersection);
        last = wide > 0.0 ? WIDE_STRATA : 0;
        WeightedLobe w = pair.core;
        for (int m = 0; m < entryLobes; ++m) {
            if (m == 1) w = pair.rest;
            LobeRay part = stratumOf(w.lobe, stratum);
            Footprint f = footprintOf(part, intersection);
            vec4 near = pictureRadiance(f);
            float share = near.w;
            vec3 around = farRadiance(part.direction, seenSigma(part));
            vec4 far = vec4(w.weight * (1.0 - share) * around, share * largest(w.weight * near.xyz));
            if (k > 0) {
                strata += far + vec4(share * w.weight * near.xyz, 0.0);
                continue;
            }
            outFar += far;
            vec2 off = f.share > 0.0 ? f.at - vec2(picturePixel()) - 0.5 : vec2(0.0);
            float shown = share * largest(w.weight) / max(largest(both), LEAST_DIVISOR);
            if (m == 0) {
                outOffsets.xy = off;
                outSpots.xz = vec2(f.variance, shown);
            } else {
                outOffsets.zw = off;
                outSpots.yw = vec2(f.variance, shown);
            }
        }
    }
    outSpots.zw *= 1.0 - wide;
    outFar = mix(outFar, strata / float(WIDE_STRATA), wide);
    if (hasLights) {
        outFar.xyz += pair.core.weight * lightsAlong(pair.core.lobe);
        if (entryLobes > 1) outFar.xyz += pair.rest.weight * lightsAlong(pair.rest.lobe);
    }
}
