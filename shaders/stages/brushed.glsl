// brushed.glsl: the reflection lobe of a brushed surface (KHR_materials_anisotropy).
// Needs    stages/reflectance.glsl; included by stages/environment_light.glsl.
// Source   environment/stretched_lobe.glsl; for --method standard the usual approximation: one lookup along the mirror direction of
//          a normal that is bent about the brushing, at the width across it.
#include "bsdf/constants.glsl"
#include "environment/stretched_lobe.glsl"
#include "stages/neighbour_groups.glsl"

vec3 standardRadiance(Surface s) {
    vec3 bent = cross(cross(s.brush, s.wo), s.brush);
    float smoothness = 1.0 - sqrt(s.alpha);
    float stretch = sqrt(max((s.along - s.alpha) / max(1.0 - s.alpha, 1e-3), 0.0)); // the strength; of alpha 1 any
    float keep = 1.0 - stretch * (1.0 - smoothness);
    keep *= keep;
    keep *= keep;
    bent = normalize(mix(normalize(bent), s.n, keep));
    ReflectionLobe lobe = fetchStandardLobe(lobeTable, s.wo, bent, s.alpha);
    return reflectedRadiance(s, lobe.direction, lobe.sigma);
}

// The mean of what arrives over the lobe.
vec3 brushedRadiance(Surface s, float edge) {
    if (method == 0) return standardRadiance(s);
    mat3 world = brushFrame(s);
    vec3 wo = s.wo * world;
    // Of several samples of a pixel each takes lobes of its own, between those of the others and narrower: of N samples
    // frame.part.w is 1 / (12 N). Half as many lobes do then, each of half of the variance, spaced by the normal distribution's
    // logistic form [BowlingKhasawneh09].
    bool several = ofPixel(frame.part.z) < 1.0;
    float shift = several ? 1.0 / (1.0 + exp(-2.4 * frame.part.x)) - 0.5 : 0.0;
    float sharpness = several ? min(sqrt(12.0 * frame.part.w), 1.0) : 1.0;
    int parts = several ? brushedLobes / 2 : brushedLobes;
    LobeGroup group = emptyGroup();
    for (int k = 0; k < parts; ++k) {
        StretchedPart part = stretchedPart(wo, brushWidths(s), k, parts, shift, sharpness);
        vec3 n = world * part.n;
        if (!(ofPixel(part.weight) > 0.0)) continue;
        for (int t = 0; t < lobeCount; ++t) {
            ReflectionLobe lobe = fetchReflectionLobeOf(lobeTable, t, lobeCount, s.wo, n, part.alpha, edge);
            addLobe(group, s, part.weight * lobe.weight, lobe.direction, sqrt(lobe.sigma * lobe.sigma + s.turn));
        }
    }
    return groupRadiance(group, s) / max(group.weight, LEAST_WEIGHT);
}
