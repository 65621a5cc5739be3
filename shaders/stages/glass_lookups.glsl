// glass_lookups.glsl: the radiance of the lobes of glass.
// Needs    stages/weighted_lobes.glsl, stages/glass_faces.glsl, stages/punctual_lights.glsl.
// Form     every lookup is made in one place: devices that run pixels in lockstep pay for all branches.
#include "bsdf/constants.glsl"

// Lobes below 4 % of the pixel's light (what clear glass reflects at normal incidence) are looked up in the environment, above 8 %
// by ray march, in between by both. Glass that absorbs shows little but its reflection.
float looked(vec3 weight, vec3 all) {
    return hasNeighbours ? smoothstep(0.04, 0.08, largest(weight / max(all, vec3(LEAST_WEIGHT)))) : 0.0;
}

// The mirror's: neighbours answer where they are known, as the picture shows their other side.
float mirrored(vec3 weight, vec3 all) { return neighbourKinds == 0 ? looked(weight, all) : 0.0; }

// Punctual lights as a lobe sees them, by its density at their directions: a Gaussian of its own width. A smooth path shows no
// point light.
vec3 lightsAlong(LobeRay lobe) {
    vec3 sum = vec3(0.0);
    float variance = lobe.sigma * lobe.sigma;
    if (!(variance > 0.0)) return sum;
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], lobe.origin);
        vec3 apart = a.wi - lobe.direction; // chords: within 4 % of the angle up to a radian
        sum += a.irradiance * exp(-0.5 * dot(apart, apart) / variance);
    }
    return sum / (2.0 * BSDF_PI * variance);
}

// Where a lobe meets what is behind. within: metres to something opaque inside that ends it; negative: none.
Intersection lobeIntersection(LobeRay lobe, float within) {
    Intersection intersection = intersectScene(lobe.origin, lobe.direction, lobe.sigma, true);
    if (holdsOpaque && within >= 0.0) {
        intersection.distance = within;
        intersection.seen = true;
    }
    return intersection;
}

// One lobe, or two that meet the same thing.
struct GlassLookup {
    WeightedLobe core;
    WeightedLobe rest;
    bool both;
    bool transmitted; // lit by punctual lights; what the outside reflects has them elsewhere (punctual_lights.glsl)
    float within;     // metres to something opaque inside that ends them; negative: none
};

GlassLookup lookupOf(WeightedLobe core) {
    GlassLookup g;
    g.core = core;
    g.rest = core;
    g.both = false;
    g.transmitted = false;
    g.within = -1.0;
    return g;
}

// By one intersection, or by one for each stratum of a wide lobe that is transmitted. What is reflected or residual is little, and
// its strata gain nothing (bottle: 1 %-trimmed relMSE .094 without, .097 with them).
vec3 lookupRadiance(GlassLookup g) {
    vec3 single = vec3(0.0);
    vec3 strata = vec3(0.0);
    vec3 lit = vec3(0.0);
    float wide = 0.0;
    int last = 0;
    int members = g.both ? 2 : 1; // in one place: see above
    for (int k = 0; k <= last; ++k) {
        vec3 stratum = stratumAt(k);
        Intersection intersection = lobeIntersection(stratumOf(g.core.lobe, stratum), g.within);
        if (k == 0 && g.transmitted && g.within < 0.0) wide = wideShare(g.core.lobe, intersection);
        last = wide > 0.0 ? WIDE_STRATA : 0;
        WeightedLobe w = g.core;
        for (int m = 0; m < members; ++m) {
            if (m == 1) w = g.rest;
            vec3 radiance = w.weight * lobeRayRadiance(stratumOf(w.lobe, stratum), intersection);
            if (k == 0) single += radiance;
            else strata += radiance;
            if (hasLights && g.transmitted && k == 0) lit += w.weight * lightsAlong(w.lobe);
        }
    }
    return mix(single, strata / float(WIDE_STRATA), wide) + lit;
}

// Radiance of the reflection lobes, beside light that is transmitted with this weight.
vec3 mirrorRadiance(MirrorLobes mirror, vec3 transmitted) {
    vec3 reflected = mirror.core.weight + mirror.rest.weight;
    vec3 all = reflected + transmitted;
    float share = mirrored(reflected, all);
    vec3 sum = vec3(0.0);
    GlassLookup g = lookupOf(mirror.core);
    g.rest = mirror.rest;
    g.both = lobeCount > 1;
    if (share > 0.0) sum += share * lookupRadiance(g);
    if (share < 1.0) sum += (1.0 - share) * aroundMirror(mirror, all);
    return sum;
}

// What the coat over glass reflects: as the mirror under it, on the picture.
vec3 coatOverGlass(Surface s, vec3 transmitted) {
    if (!hasCoat) return vec3(0.0);
    Surface coat = coatSurface(s);
    float share = coatKeeps(s, coat);
    vec3 sum = vec3(0.0);
    if (hasEnvironment) {
        EnvironmentLight light = coatLobe(coat);
        light.weight *= share;
        sum += mirrorRadiance(mirrorLobes(coat, light), transmitted);
    }
    if (hasLights) sum += share * coatLights(coat);
    return sum;
}

// Radiance of all lobes: core and rest, internally reflected, residual and reflection, each with its own intersection.
vec3 glassRadiance(GlassLobes lobes, MirrorLobes mirror) {
    vec3 sum = vec3(0.0);
    // What comes from behind the viewer no picture shows.
    if (losesItsWay && hasEnvironment) {
        lobes.residual.weight *= 0.5;
        sum += lobes.residual.weight * wideRadiance(-lobes.residual.lobe.direction);
    }
    float reflectedInside = largest(lobes.reflectedInside.weight) > 0.0 ? 1.0 : 0.0;
    vec3 reflected = mirror.core.weight + mirror.rest.weight;
    vec3 all = reflected + lobes.core.weight + lobes.rest.weight + lobes.reflectedInside.weight + lobes.residual.weight;
    vec3 wanted = vec3(reflectedInside, mirrored(reflected, all), looked(lobes.residual.weight, all));
    // Pixels in lockstep take as long as the slowest: the march is short where only the core is looked up.
    int group = 0;
    while (group < 4) {
        GlassLookup g = lookupOf(lobes.core);
        float share = 1.0;
        if (group == 0) {
            g.rest = lobes.rest;
            g.both = entryLobes > 1;
            g.within = lobes.within;
        } else if (group == 1) {
            g.core = lobes.reflectedInside;
            share = wanted.x;
        } else if (group == 2) {
            g.core = mirror.core;
            g.rest = mirror.rest;
            g.both = lobeCount > 1;
            share = wanted.y;
        } else {
            g.core = lobes.residual;
            share = wanted.z;
        }
        g.transmitted = group < 2;
        sum += share * lookupRadiance(g);
        ++group;
        if (group == 1 && wanted.x == 0.0) ++group;
        if (group == 2 && wanted.y == 0.0) ++group;
        if (group == 3 && wanted.z == 0.0) ++group;
    }
    if (hasEnvironment) sum += (1.0 - wanted.y) * aroundMirror(mirror, all);
    if (transmission == 1) return sum; // a wall has no residual energy
    // Where it always scatters diffusely, the widest lookup does.
    vec3 left = interiorPairs < 2 ? farLobe(lobes.residual) : lobes.residual.weight * wideRadiance(lobes.residual.lobe.direction);
    return sum + (1.0 - wanted.z) * left;
}
