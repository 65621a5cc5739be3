// thin_wall.glsl: transmission of a wall of no thickness, as lobes that leave it, and the reflections from within it.
// Frame    world, metres; directions unit.
// Needs    stages/weighted_lobes.glsl, stages/glass_faces.glsl.
// Source   refraction/thin_wall_table.glsl: all orders of reflection between the two faces.
#include "bsdf/constants.glsl"
#include "refraction/thin_wall_table_fetch.glsl"

layout(binding = 29) uniform sampler3D wallEnergyTable;
layout(binding = 30) uniform sampler3D wallLobeTable;

struct ThinWall {
    GlassLobes through;
    float reflectedLater; // what comes back from within, in the mirror direction
};

ThinWallEnergy wallEnergy(float cosTheta, float alpha, float ior) {
    if (!isSmooth) return fetchThinWallEnergy(wallEnergyTable, cosTheta, alpha, ior);
    float f = fresnelDielectricAt(cosTheta, ior);
    ThinWallEnergy e;
    e.transmitted = (1.0 - f) / (1.0 + f); // (1 - F)² (1 + F² + F⁴ + ...)
    e.reflectedFirst = f;
    e.reflectedLater = f * e.transmitted;
    return e;
}

WeightedLobe wallLobe(Surface s, int lobe, float ior, float transmitted) {
    if (isSmooth) {
        WeightedLobe straight;
        straight.lobe = lobeRay(s.position, -s.wo, 0.0);
        straight.weight = vec3(transmitted);
        return straight;
    }
    InterfaceLobe read = fetchThinWallLobe(wallLobeTable, lobe, entryLobes, dot(s.wo, s.n), s.alpha, ior);
    WeightedLobe w;
    w.lobe = lobeRay(s.position, interfaceLobeDirection(s.wo, s.n, read.angle), read.sigma);
    w.weight = vec3(read.weight * transmitted);
    return w;
}

ThinWall throughThinWall(Surface s, float ior) {
    ThinWallEnergy energy = wallEnergy(dot(s.wo, s.n), s.alpha, ior);
    ThinWall wall;
    wall.reflectedLater = energy.reflectedLater;
    wall.through.core = wallLobe(s, 0, ior, energy.transmitted);
    wall.through.rest = noLobe(s.position, s.n);
    if (entryLobes > 1) wall.through.rest = wallLobe(s, 1, ior, energy.transmitted);
    wall.through.reflectedInside = noLobe(s.position, s.n);
    wall.through.residual = noLobe(s.position, s.n);
    wall.through.within = -1.0;
    // The far face, for those who sample both.
    wall.through.leaving.n = -s.n;
    wall.through.leaving.alpha = s.alpha;
    wall.through.leaving.eta = 1.0 / ior;
    wall.through.leaving.turn = vec2(0.0);
    wall.through.inner = refractAbout(s.wo, s.n, ior);
    return wall;
}

// The reflection lobes, with those from within the wall: the same directions, wider.
MirrorLobes withReflectedLater(MirrorLobes mirror, vec3 later, float ior) {
    vec3 before = mirror.core.weight + mirror.rest.weight;
    vec3 more = 1.0 + later / max(before, vec3(LEAST_DIVISOR));
    float share = 1.0 - 1.0 / largest(more);
    float wider = sqrt(mix(1.0, thinWallLaterSpread(ior) * thinWallLaterSpread(ior), share));
    MirrorLobes both = mirror;
    both.core.lobe.sigma *= wider;
    both.core.weight *= more;
    both.rest.lobe.sigma *= wider;
    both.rest.weight *= more;
    return both;
}
