// neighbour_shadows.glsl: the transmittance of neighbours for a lamp's or a sun's light.
// Frame    world, metres; directions unit.
// Needs    stages/neighbours.glsl, which includes it.
#include "bsdf/constants.glsl"

// A ball of glass is a lens: parallel light converges about its axis at a focal length of ior / (2 (ior - 1)) radii from its
// centre, and diverges again. Irradiance at a point at `centre` from the ball's, over that without the ball.
float ballGathers(vec3 centre, float radius, vec3 wi, float ior, float alpha) {
    float focal = ior * radius / max(2.0 * (ior - 1.0), 1e-2); // IOR within .005 of 1 does not focus
    float x = dot(centre, wi);
    float paraxial = radius * (x - focal) / focal;
    float rough = ballSigma(alpha, ior, 0.7) * x; // at the mean cosine of a ball
    float r2 = radius * radius;
    float x2 = paraxial * paraxial + rough * rough + 0.0625 * r2;
    vec3 beside = centre - x * wi;
    float b2 = dot(beside, beside);
    // Its aberration: rays near its rim, half of all, cross far before the focus.
    float wide2 = x2 + r2;
    return 0.5 * r2 * (exp(-b2 / x2) / x2 + exp(-b2 / wide2) / wide2);
}

// Transmittance of all neighbours in between, for a light at `range` metres (1e30: directional); sigma: half of its angular radius.
vec3 passesNeighbours(vec3 p, vec3 wi, float range, float sigma) {
    Composed c = nothingTaken();
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NeighbourData o = neighbours.each[i];
        LobeShare met = neighbourShare(o, o.centre.xyz - p, wi, sigma);
        if (startsBody(o)) c = nextBody(c);
        if (met.share < LEAST_SHARE || met.distance > range) continue;
        vec3 tint = vec3(0.0);
        if (isGlass(o)) {
            tint = passedBy(o, max(dot(-wi, met.n), 0.0));
            if (isSphere(o)) tint *= ballGathers(o.centre.xyz - p, o.centre.w, wi, o.emission.w, o.base.w);
        }
        c = withTaken(c, met.share, tint);
    }
    return c.passed;
}

// The same of balls of glass alone: shadow maps have all else (needs/shadow_maps.h).
vec3 passesLenses(vec3 p, vec3 wi, float range) {
    vec3 passed = vec3(1.0);
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NeighbourData o = neighbours.each[i];
        if (!(ofPixel(o.through.w) > 0.0)) continue;
        vec3 centre = o.centre.xyz - p;
        LobeShare met = sphereShare(centre, o.centre.w, wi, 0.0);
        if (met.share < LEAST_SHARE || met.distance > range) continue;
        vec3 tint = passedBy(o, max(dot(-wi, met.n), 0.0)) * ballGathers(centre, o.centre.w, wi, o.emission.w, o.base.w);
        passed *= 1.0 - met.share * (1.0 - tint);
    }
    return passed;
}
