// glass_beams.glsl: the beams that glass sends, and what they are made of.
// Frame    world, metres; directions unit.
// Needs    stages/surface.glsl, stages/surroundings.glsl, stages/environment_light.glsl.
#include "refraction/composition_fetch.glsl"

struct WeightedBeam {
    Beam beam;
    vec3 weight; // 0: it is not there
};

// What one pixel of glass sends, besides its reflection. The first two leave at one place and meet the same thing.
struct GlassBeams {
    WeightedBeam core;
    WeightedBeam rest;
    WeightedBeam bounced;  // leaves after total reflection
    WeightedBeam leftOver;
    ExitSurface leaving; // where the first two leave, by which ray from within
    vec3 inner;
    float within; // metres to something opaque inside that ends the core; negative: none
};

// The glass's own reflection.
struct MirrorBeams {
    WeightedBeam core;
    WeightedBeam rest; // not there where the lobe's table has one tap
};

WeightedBeam weighted(ComposedTap tap, vec3 origin, float inside, vec3 weight) {
    WeightedBeam w;
    w.beam = straightBeam(origin, tap.direction, tap.sigma);
    w.beam.inner = tap.inner;
    w.beam.carried = tap.carried;
    w.beam.inside = inside;
    w.weight = tap.weight * weight;
    return w;
}

WeightedBeam noBeam(vec3 origin, vec3 direction) {
    WeightedBeam w;
    w.beam = straightBeam(origin, direction, 0.0);
    w.weight = vec3(0.0);
    return w;
}

MirrorBeams noMirror(Surface s) {
    MirrorBeams mirror;
    mirror.core = noBeam(s.position, s.n);
    mirror.rest = mirror.core;
    return mirror;
}

WeightedBeam mirrorBeam(Surface s, EnvironmentLight light, LobeTap tap) {
    WeightedBeam w;
    w.beam = straightBeam(s.position, tap.direction, tap.sigma);
    w.beam.turn = s.turn;
    w.weight = light.weight * tap.weight;
    return w;
}

vec3 farBeam(WeightedBeam w) { return w.weight * farRadiance(w.beam.direction, seenSigma(w.beam)); }

vec3 farMirror(MirrorBeams mirror) {
    vec3 sum = farBeam(mirror.core);
    if (lobeTaps > 1) sum += farBeam(mirror.rest);
    return sum;
}

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }
