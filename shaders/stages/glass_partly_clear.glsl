// glass_partly_clear.glsl: solids whose faces are clear in part only: transmission below 1, or metal.
// Needs    stages/weighted_lobes.glsl, stages/glass_far_face.glsl.
// Source   app/README.md, "Bodies of glass": where a face is not clear it shows its base.
// Limits   the base within is lit alike from all sides, and metal counts as if it were diffuse.
#include "bsdf/constants.glsl"

// Share of the light around the solid that its inner base sends: an integrating cavity. Its wall passes light by the clear share,
// reflects by Fresnel's mean for diffuse light (at 60 degrees, within .005) and by its base.
vec3 baseWithin(vec3 baseColor, float clear, float ior) {
    float leaves = clear * clamp((1.0 - fresnelDielectricAt(0.5, ior)) / (ior * ior), 0.0, 1.0);
    return baseColor * leaves / max(vec3(1.0) - (1.0 - clear) * baseColor - vec3(clear - leaves), vec3(LEAST_WEIGHT));
}

// Light that the lobes lose at partly opaque faces is replaced by the radiance of their base: at the first face, and, for
// internally reflected light, at the last. It enters and leaves by the clear share of the near face.
vec3 baseSeenWithin(GlassLobes lobes, FarFace near, FarFace first, FarFace last, float ior) {
    vec3 direct = (1.0 - first.clear) * baseWithin(first.tint * first.tint, near.clear, ior);
    vec3 reflected = (1.0 - first.clear * last.clear) * baseWithin(last.tint * last.tint, near.clear, ior);
    return direct * (lobes.core.weight + lobes.rest.weight) +
           reflected * (lobes.reflectedInside.weight + lobes.residual.weight);
}

// The clear share of both faces for each lobe. entry: of the near one.
GlassLobes throughFarFaces(GlassLobes lobes, vec3 entry, FarFace first, FarFace last) {
    GlassLobes b = lobes;
    vec3 direct = entry * first.tint * first.clear;
    vec3 reflected = entry * last.tint * (first.clear * last.clear);
    b.core.weight *= direct;
    b.rest.weight *= direct;
    b.reflectedInside.weight *= reflected;
    b.residual.weight *= reflected;
    return b;
}
