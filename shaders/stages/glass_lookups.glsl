// glass_lookups.glsl: what the beams of glass bring.
// Needs    stages/glass_beams.glsl, stages/glass_faces.glsl, stages/punctual_lights.glsl.
// Form     every lookup is made in one place: machines that run pixels in lockstep pay for all that is written, taken or not.

// How far a beam is looked for on the picture: what brings less of all that is seen than clear glass reflects of light that meets
// it squarely, 4 %, is not, at twice that it is in full. The environment stands in. Glass that absorbs shows little but its mirror.
float looked(vec3 weight, vec3 all) { return looksAround ? smoothstep(0.04, 0.08, largest(weight / max(all, vec3(1e-6)))) : 0.0; }

// Punctual lights as a beam sees them, by its density at their directions: a Gaussian of its own width. A smooth path shows a
// point of light to nobody.
vec3 lightsAlong(Beam beam) {
    vec3 sum = vec3(0.0);
    float variance = beam.sigma * beam.sigma;
    if (!(variance > 0.0)) return sum;
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], beam.origin);
        vec3 apart = a.wi - beam.direction; // chords: within 4 % of the angle up to a radian
        sum += a.irradiance * exp(-0.5 * dot(apart, apart) / variance);
    }
    return sum / (2.0 * BSDF_PI * variance);
}

// Where the first of two beams that meet the same thing meets it. within: metres to something opaque inside that ends it; negative:
// none.
Meeting pairMeeting(WeightedBeam core, float within) {
    Beam part = partOf(core.beam);
    Meeting meeting = meetBackdrop(part.origin, part.direction, part.sigma, true);
    if (holdsOpaque && within >= 0.0) {
        meeting.distance = within;
        meeting.seen = true;
    }
    return meeting;
}

// What both bring, or the first alone. lit: punctual lights too; what the outside reflects has them elsewhere (punctual_lights.glsl).
vec3 pairRadiance(WeightedBeam core, WeightedBeam rest, bool both, float within, bool lit) {
    vec3 sum = vec3(0.0);
    Meeting meeting = pairMeeting(core, within);
    WeightedBeam w = core;
    int members = both ? 2 : 1; // in one place: see above
    for (int m = 0; m < members; ++m) {
        if (m == 1) w = rest;
        sum += w.weight * beamRadiance(partOf(w.beam), meeting);
        if (hasLights && lit) sum += w.weight * lightsAlong(w.beam);
    }
    return sum;
}

// What the mirror's beams bring, beside light that is transmitted with so much weight.
vec3 mirrorRadiance(MirrorBeams mirror, vec3 transmitted) {
    vec3 reflected = mirror.core.weight + mirror.rest.weight;
    float share = looked(reflected, reflected + transmitted);
    vec3 sum = vec3(0.0);
    if (share > 0.0) sum += share * pairRadiance(mirror.core, mirror.rest, lobeTaps > 1, -1.0, false);
    if (share < 1.0) sum += (1.0 - share) * farMirror(mirror);
    return sum;
}

// What the beams bring: core and rest, what bounced, what is left over and the mirror's, those that are looked for each by its own
// meeting.
vec3 glassRadiance(GlassBeams beams, MirrorBeams mirror) {
    vec3 sum = vec3(0.0);
    // What comes from behind the viewer no picture shows.
    if (losesItsWay && hasEnvironment) {
        beams.leftOver.weight *= 0.5;
        sum += beams.leftOver.weight * wideRadiance(-beams.leftOver.beam.direction);
    }
    float bounced = largest(beams.bounced.weight) > 0.0 ? 1.0 : 0.0;
    vec3 reflected = mirror.core.weight + mirror.rest.weight;
    vec3 all = reflected + beams.core.weight + beams.rest.weight + beams.bounced.weight + beams.leftOver.weight;
    vec3 wanted = vec3(bounced, looked(reflected, all), looked(beams.leftOver.weight, all));
    // Lanes of a group run as long as the longest: the way is short where nothing but the core is looked for.
    int group = 0;
    while (group < 4) {
        WeightedBeam w = beams.core;
        float share = 1.0;
        if (group == 1) {
            w = beams.bounced;
            share = wanted.x;
        } else if (group == 2) {
            w = mirror.core;
            share = wanted.y;
        } else if (group == 3) {
            w = beams.leftOver;
            share = wanted.z;
        }
        Beam part = partOf(w.beam);
        Meeting meeting = meetBackdrop(part.origin, part.direction, part.sigma, true);
        if (group == 0 && beams.within >= 0.0) {
            meeting.distance = beams.within;
            meeting.seen = true;
        }
        int members = (group == 0 && entryTaps > 1) || (group == 2 && lobeTaps > 1) ? 2 : 1;
        for (int m = 0; m < members; ++m) {
            if (m == 1) {
                w = beams.rest;
                if (group == 2) w = mirror.rest;
                part = partOf(w.beam);
            }
            sum += share * w.weight * beamRadiance(part, meeting);
            if (hasLights && group < 2) sum += w.weight * lightsAlong(w.beam);
        }
        ++group;
        if (group == 1 && wanted.x == 0.0) ++group;
        if (group == 2 && wanted.y == 0.0) ++group;
        if (group == 3 && wanted.z == 0.0) ++group;
    }
    if (hasEnvironment) sum += (1.0 - wanted.y) * farMirror(mirror);
    if (transmission == 1) return sum; // nothing is left over in a wall
    // Where it has always lost its way, the widest lookup does.
    vec3 left = interiorPairs < 2 ? farBeam(beams.leftOver) : beams.leftOver.weight * wideRadiance(beams.leftOver.beam.direction);
    return sum + (1.0 - wanted.z) * left;
}
