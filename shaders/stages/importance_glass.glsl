// importance_glass.glsl: `--method fisN` through glass: a facet of either face for each of N samples.
// Frame    world, metres; directions unit.
// Needs    stages/importance.glsl, stages/weighted_lobes.glsl, stages/glass_faces.glsl, stages/glass.glsl.
// Limits   a sample's width is its share of the lobe's first-order width, as the density of two facets in a row has no closed form.

// Masking-shadowing over masking, for a facet drawn among those that are visible.
float facetThrough(vec3 wo, vec3 wi, vec3 wm, float alpha, float eta) {
    return facetWeight(wm, alpha) * fresnelTransmittedAt(dot(wo, wm), eta) * ggxG1(tilt(wi), alpha);
}

// Radiance through both faces: a facet of each, in the place of `lobes`' core and rest.
vec3 sampledGlass(Surface s, float ior, GlassLobes lobes, int n) {
    ExitSurface leaving = lobes.leaving;
    mat3 entry = frameAbout(s.n);
    vec3 wo = transpose(entry) * s.wo;
    float inside = lobes.core.lobe.inside;
    vec3 absorption = absorbed(inside);
    Intersection intersection = intersectScene(lobes.core.lobe.origin, lobes.core.lobe.direction, lobes.core.lobe.sigma, true);
    // Both lobes to first order, and of their joint Gaussian each sample's share: 0.35 sqrt(2 pi).
    float first = ior * interfaceWidth(wo.z, s.alpha, ior);
    float second = interfaceWidth(dot(lobes.inner, leaving.n), leaving.alpha, leaving.eta);
    float sigma = 0.877 * inversesqrt(float(n)) * sqrt(first * first + second * second);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < n; ++i) {
        vec2 u = hammersley(i, n);
        vec3 wm = ggxSampleVisible(wo, vec2(s.alpha), u);
        vec3 inner = refractAbout(wo, wm, ior); // as it travels
        vec3 d = entry * inner;
        ExitSurface there = exitBeside(leaving, lobes.inner, d - lobes.inner);
        mat3 exit = frameAbout(-there.n);
        vec3 back = transpose(exit) * -d;
        // The golden ratio's lattice decouples the second face's facets from the first's.
        vec3 wm2 = ggxSampleVisible(back, vec2(there.alpha), fract(u.yx + vec2(0.618034, 0.754878) * float(i)));
        vec3 outer = refractAbout(back, wm2, there.eta);
        if (!(inner.z < 0.0 && back.z > 0.0 && outer.z < 0.0)) continue;
        float weight = facetThrough(wo, inner, wm, s.alpha, ior) * facetThrough(back, outer, wm2, there.alpha, there.eta);
        vec3 beside = inside * (d - lobes.inner);
        beside -= dot(beside, leaving.n) * leaving.n;
        LobeRay lobe = lobeRay(lobes.core.lobe.origin + beside, exit * outer, sigma);
        lobe.turn = lobes.core.lobe.turn;
        sum += weight * lobeRayRadiance(lobe, intersection);
    }
    return absorption * sum / float(n);
}
