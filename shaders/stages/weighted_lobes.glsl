// weighted_lobes.glsl: lobes of glass and their weights.
// Frame    world, metres; directions unit.
// Needs    stages/surface.glsl, stages/surroundings.glsl, stages/environment_light.glsl.
#include "bsdf/constants.glsl"
#include "refraction/composition_fetch.glsl"

struct WeightedLobe {
    LobeRay lobe;
    vec3 weight; // 0: it is not there
};

// What one pixel of glass sends, besides its reflection. The first two leave at one place and meet the same thing.
struct GlassLobes {
    WeightedLobe core;
    WeightedLobe rest;
    WeightedLobe reflectedInside;  // leaves after total reflection
    WeightedLobe residual;
    ExitSurface leaving; // where the first two leave, by which ray from within
    vec3 inner;
    float within; // metres to something opaque inside that ends the core; negative: none
};

// The glass's own reflection.
struct MirrorLobes {
    WeightedLobe core;
    WeightedLobe rest; // not there where the lobe's table has one lobe
    vec3 n; // of what reflects
};

WeightedLobe weighted(ComposedLobe lobe, vec3 origin, float inside, vec3 weight) {
    WeightedLobe w;
    w.lobe = lobeRay(origin, lobe.direction, lobe.sigma);
    w.lobe.inner = lobe.inner;
    w.lobe.carried = lobe.carried;
    w.lobe.inside = inside;
    w.weight = lobe.weight * weight;
    return w;
}

WeightedLobe noLobe(vec3 origin, vec3 direction) {
    WeightedLobe w;
    w.lobe = lobeRay(origin, direction, 0.0);
    w.weight = vec3(0.0);
    return w;
}

MirrorLobes noMirror(Surface s) {
    MirrorLobes mirror;
    mirror.core = noLobe(s.position, s.n);
    mirror.rest = mirror.core;
    mirror.n = s.n;
    return mirror;
}

WeightedLobe mirrorLobe(Surface s, EnvironmentLight light, ReflectionLobe lobe) {
    WeightedLobe w;
    w.lobe = lobeRay(s.position, lobe.direction, lobe.sigma);
    w.lobe.turn = s.turn;
    w.weight = light.weight * lobe.weight;
    return w;
}

MirrorLobes mirrorLobes(Surface s, EnvironmentLight light) {
    MirrorLobes mirror = noMirror(s);
    mirror.core = mirrorLobe(s, light, light.lobe);
    if (lobeCount > 1) mirror.rest = mirrorLobe(s, light, mergedTail(s, light));
    return mirror;
}

vec3 farLobe(WeightedLobe w) { return w.weight * farRadiance(w.lobe.direction, seenSigma(w.lobe)); }

vec3 farMirror(MirrorLobes mirror) {
    vec3 sum = farLobe(mirror.core);
    if (lobeCount > 1) sum += farLobe(mirror.rest);
    return sum;
}

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// Past neighbours, which one lobe of the same mean and variance is asked for; all: of what the pixel shows beside it.
vec3 aroundMirror(MirrorLobes mirror, vec3 all) {
    vec3 far = farMirror(mirror);
    if (neighbourKinds == 0) return far;
    ReflectionLobe lobe;
    lobe.direction = mirror.core.lobe.direction;
    lobe.sigma = mirror.core.lobe.sigma;
    lobe.weight = meanOf(mirror.core.weight);
    vec3 weight = mirror.core.weight;
    if (lobeCount > 1) {
        ReflectionLobe rest = lobe;
        rest.direction = mirror.rest.lobe.direction;
        rest.sigma = mirror.rest.lobe.sigma;
        rest.weight = meanOf(mirror.rest.weight);
        lobe = mergedLobes(lobe, rest);
        weight += mirror.rest.weight;
    }
    float sigma = sqrt(lobe.sigma * lobe.sigma + mirror.core.lobe.turn);
    return weight * surroundingRadiance(mirror.core.lobe.origin, mirror.n, lobe.direction, sigma, far / max(weight, vec3(LEAST_WEIGHT)),
                                        leastShareOf(weight, all));
}
