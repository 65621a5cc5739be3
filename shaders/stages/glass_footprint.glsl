// glass_footprint.glsl: the footprints on the picture of the lobes that leave a solid of glass, for glass_resolve.frag, which does
// their lookups at every pixel.
// Layout   floats of 32 bits: places are looked up within a fraction of a pixel, radiance exceeds half floats.
//          offsets  xy of core, zw of rest, pixels from the fragment's own
//          spots    xy variances of both, pixels²; zw the shares of lobeColor that the picture covers
//          lobes    rgb weight of both together; w the number of the solid (stages/object.glsl), 0 where there is none
//          far      rgb radiance that does not come from the picture; w the largest channel of what does
#include "stages/glass_material.glsl"
#include "stages/glass_look.glsl"

layout(location = 0) out vec4 outOffsets;
layout(location = 1) out vec4 outSpots;
layout(location = 2) out vec4 outLobes;
layout(location = 3) out vec4 outFar;

void writeFootprint() {
    LobePair pair = readLobes();
    Intersection intersection = pairIntersection(pair.core, endWithinGlass());
    vec3 both = pair.core.weight + pair.rest.weight;
    if (entryLobes == 1) both = pair.core.weight;
    outOffsets = vec4(0.0);
    outSpots = vec4(0.0);
    outLobes = vec4(both, float(objectId()));
    outFar = vec4(0.0);
    WeightedLobe w = pair.core;
    for (int m = 0; m < entryLobes; ++m) {
        if (m == 1) w = pair.rest;
        LobeRay part = partOf(w.lobe);
        Footprint f = footprintOf(part, intersection);
        vec4 near = pictureRadiance(f);
        float share = near.w;
        outFar.w += share * largest(w.weight * near.xyz);
        outFar.xyz += w.weight * (1.0 - share) * farRadiance(part.direction, seenSigma(part));
        if (hasLights) outFar.xyz += w.weight * lightsAlong(w.lobe);
        vec2 off = f.share > 0.0 ? f.at - vec2(picturePixel()) - 0.5 : vec2(0.0);
        float shown = share * largest(w.weight) / max(largest(both), 1e-30);
        if (m == 0) {
            outOffsets.xy = off;
            outSpots.xz = vec2(f.variance, shown);
        } else {
            outOffsets.zw = off;
            outSpots.yw = vec2(f.variance, shown);
        }
    }
}
