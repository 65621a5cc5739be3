// glass_lookups.glsl: what the lobes of glass bring.
// Needs    stages/weighted_lobes.glsl, stages/glass_faces.glsl, stages/punctual_lights.glsl.
// Form     every lookup is made in one place: machines that run pixels in lockstep pay for all that is written, taken or not.

// How far a lobe is looked for on the picture: what brings less of all that is seen than clear glass reflects of light that meets
// it squarely, 4 %, is not, at twice that it is in full. The environment stands in. Glass that absorbs shows little but its mirror.
float looked(vec3 weight, vec3 all) { return hasNeighbours ? smoothstep(0.04, 0.08, largest(weight / max(all, vec3(1e-6)))) : 0.0; }

// The mirror's: neighbours answer where they are known, as the picture shows their other side.
float mirrored(vec3 weight, vec3 all) { return neighbourKinds == 0 ? looked(weight, all) : 0.0; }

// Punctual lights as a lobe sees them, by its density at their directions: a Gaussian of its own width. A smooth path shows a
// point of light to nobody.
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

// Where the first of two lobes that meet the same thing meets it. within: metres to something opaque inside that ends it; negative:
// none.
Intersection pairIntersection(WeightedLobe core, float within) {
    LobeRay part = partOf(core.lobe);
    Intersection intersection = meetBackdrop(part.origin, part.direction, part.sigma, true);
    if (holdsOpaque && within >= 0.0) {
        intersection.distance = within;
        intersection.seen = true;
    }
    return intersection;
}

// What both bring, or the first alone. lit: punctual lights too; what the outside reflects has them elsewhere
// (punctual_lights.glsl).
vec3 pairRadiance(WeightedLobe core, WeightedLobe rest, bool both, float within, bool lit) {
    vec3 sum = vec3(0.0);
    Intersection intersection = pairIntersection(core, within);
    WeightedLobe w = core;
    int members = both ? 2 : 1; // in one place: see above
    for (int m = 0; m < members; ++m) {
        if (m == 1) w = rest;
        sum += w.weight * lobeRayRadiance(partOf(w.lobe), intersection);
        if (hasLights && lit) sum += w.weight * lightsAlong(w.lobe);
    }
    return sum;
}

// What the mirror's lobes bring, beside light that is transmitted with so much weight.
vec3 mirrorRadiance(MirrorLobes mirror, vec3 transmitted) {
    vec3 reflected = mirror.core.weight + mirror.rest.weight;
    vec3 all = reflected + transmitted;
    float share = mirrored(reflected, all);
    vec3 sum = vec3(0.0);
    if (share > 0.0) sum += share * pairRadiance(mirror.core, mirror.rest, lobeCount > 1, -1.0, false);
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

// What the lobes bring: core and rest, what is internally reflected, residual energy and the mirror's, those that are looked for
// each by its own intersection.
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
    // Lanes of a group run as long as the longest: the way is short where nothing but the core is looked for.
    int group = 0;
    while (group < 4) {
        WeightedLobe w = lobes.core;
        float share = 1.0;
        if (group == 1) {
            w = lobes.reflectedInside;
            share = wanted.x;
        } else if (group == 2) {
            w = mirror.core;
            share = wanted.y;
        } else if (group == 3) {
            w = lobes.residual;
            share = wanted.z;
        }
        LobeRay part = partOf(w.lobe);
        Intersection intersection = meetBackdrop(part.origin, part.direction, part.sigma, true);
        if (group == 0 && lobes.within >= 0.0) {
            intersection.distance = lobes.within;
            intersection.seen = true;
        }
        int members = (group == 0 && entryLobes > 1) || (group == 2 && lobeCount > 1) ? 2 : 1;
        for (int m = 0; m < members; ++m) {
            if (m == 1) {
                w = lobes.rest;
                if (group == 2) w = mirror.rest;
                part = partOf(w.lobe);
            }
            sum += share * w.weight * lobeRayRadiance(part, intersection);
            if (hasLights && group < 2) sum += w.weight * lightsAlong(w.lobe);
        }
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
