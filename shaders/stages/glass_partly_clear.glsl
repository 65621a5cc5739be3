// glass_partly_clear.glsl: solids whose faces are clear in part only: transmission below 1, or metal.
// Needs    stages/weighted_lobes.glsl, stages/surroundings.glsl.
// Source   app/README.md, "Bodies of glass": each face is clear by the share that the near one is; the rest of it shows its base.
// Limits   the base within is lit alike from all sides, and metal counts as if it were diffuse.

vec3 energyOf(GlassLobes lobes) { return lobes.core.weight + lobes.rest.weight + lobes.reflectedInside.weight + lobes.residual.weight; }

// What meets the clear share of every face on its way: one at least, and two of what the first has reflected.
GlassLobes throughClearShare(GlassLobes lobes, float clear) {
    GlassLobes b = lobes;
    b.core.weight *= clear;
    b.rest.weight *= clear;
    b.reflectedInside.weight *= clear * clear;
    b.residual.weight *= clear * clear;
    return b;
}

// The base that is seen within shows so much of the light around the solid: a cavity whose wall lets light in and out by its clear
// share, reflects the rest of that by Fresnel's mean for diffuse light (at 60 degrees, within .005), and by its base beside it.
vec3 baseWithin(vec3 baseColor, float clear, float ior) {
    float leaves = clear * clamp((1.0 - fresnelDielectricAt(0.5, ior)) / (ior * ior), 0.0, 1.0);
    return baseColor * leaves / max(vec3(1.0) - (1.0 - clear) * baseColor - vec3(clear - leaves), vec3(1e-6));
}
