// neighbours.glsl: light that arrives past what stands around: the radiance of neighbours where they take a share of a lobe, the
// environment for the rest.
// Frame    world, metres; directions unit.
// Needs    interface/frame.glsl, stages/environment.glsl, stages/material_features.glsl.
// Source   neighbours/lobe_share.glsl, neighbours/form_factor.glsl; each neighbour by its own material, lit by the environment alone: one
//          bounce. Front to back in the order of the list; the faces of one box lie beside each other.
#include "bsdf/constants.glsl"
#include "interface/neighbours.glsl"
#include "neighbours/form_factor.glsl"
#include "neighbours/lobe_share.glsl"
#include "neighbours/proxy_lobe.glsl"
#include "stages/far_radiance.glsl"
#include "stages/light_arrival.glsl"

const bool spheresAround = (neighbourKinds & 1) != 0;
const bool rectanglesAround = (neighbourKinds & 2) != 0;
const bool glassAround = (neighbourKinds & 4) != 0;
const float LEAST_SHARE = 0.004; // a step of 8 bits

bool isSphere(NeighbourData o) { return spheresAround && (!rectanglesAround || ofPixel(o.centre.w) > 0.0); }

// A face of a box has nothing to show to who is behind it.
bool isTurnedAway(NeighbourData o, vec3 centre) { return ofPixel(o.sideU.w) > 0.0 && dot(cross(o.sideU.xyz, o.sideV.xyz), centre) >= 0.0; }

// How much of its share each takes, when those before have taken theirs, and the moments of what is left: what a lobe has in all
// is what is met and what passes together.
struct Composed {
    vec3 before;   // that passes all bodies before this one
    float taken;   // by this body
    vec3 passed;
    vec3 mean;     // of the directions that pass, times their share
    float squares; // of the angles per axis to the middle of the lobe, the same
};

Composed nothingTaken(vec3 mean, float squares) {
    Composed c;
    c.before = vec3(1.0);
    c.taken = 0.0;
    c.passed = vec3(1.0);
    c.mean = mean;
    c.squares = squares;
    return c;
}

// Of two rectangles of one body the second continues the first: what one covers the other does not.
Composed nextBody(Composed c, NeighbourData o) {
    if (ofPixel(o.sideV.w) > 0.0) return c;
    c.before = c.passed;
    c.taken = 0.0;
    return c;
}

// What is taken of all, and what is left. `tint` of it passes.
float ownShare(Composed c, float share) { return min(share, 1.0 - c.taken); }

Composed withTaken(Composed c, float share, vec3 tint, vec3 direction, float square) {
    float own = ownShare(c, share);
    c.taken += own;
    float all = own * c.before.y;
    c.mean -= all * direction;
    c.squares -= all * square;
    c.passed -= c.before * own * (1.0 - tint);
    return c;
}

// Where light leaves a ball of glass that it enters along -wo at the normal n.
vec3 throughBall(vec3 wo, vec3 n, float ior) {
    float c = max(dot(wo, n), 0.05);
    float root = sqrt(max(1.0 - (1.0 - c * c) / (ior * ior), 0.0));
    vec3 inside = -wo / ior + (c / ior - root) * n;
    // The chord mirrors the normal: the second face bends by as much as the first.
    vec3 far = n + 2.0 * root * inside;
    return normalize(ior * inside + (ior * root - c) * (-far));
}

// What the receiver's own body takes of the light of its neighbours, and what it gives them: light is between the two once more.
const bool knowsOwn = ownProxy != 0;
const bool ownIsSphere = ownProxy == 1;
NeighbourData ownBody() { return neighbours.each[ofPixel(MOST_NEIGHBOURS)]; }

vec3 ownNormal(vec3 towards) {
    if (ownIsSphere) return -towards;
    vec3 n = normalize(cross(ownBody().sideU.xyz, ownBody().sideV.xyz));
    return dot(n, towards) > 0.0 ? -n : n;
}

vec3 ownRadiance(vec3 towards) { return ownBody().base.xyz * wideRadiance(ownNormal(towards)); }

vec3 lightAcross(vec3 p, vec3 n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], p);
        sum += a.irradiance * max(dot(n, a.wi), 0.0);
    }
    return sum / BSDF_PI;
}

LobeShare ownShareOf(vec3 p, vec3 direction, float sigma) {
    vec3 c = ownBody().centre.xyz - p;
    if (ownIsSphere) return sphereShare(c, ownBody().centre.w, direction, sigma);
    return rectangleShare(c, ownBody().sideU.xyz, ownBody().sideV.xyz, direction, sigma);
}

// A sun in the environment is a light of its own.
vec3 sunAcross(vec3 n) { return frame.sunIrradiance.xyz * (max(dot(n, frame.sunDirection.xyz), 0.0) / BSDF_PI); }

// lit: how much of its light the receiver keeps when the neighbour has taken its share of it.
vec3 irradianceOf(vec3 p, vec3 n, float lit) {
    vec3 sun = sunAcross(n);
    vec3 around = max(wideRadiance(n) - sun, vec3(0.0));
    vec3 c = ownBody().centre.xyz - p;
    if (knowsOwn) {
        float share;
        vec3 towards;
        if (ownIsSphere) {
            share = sphereFormFactor(c, ownBody().centre.w, n);
            towards = normalize(c);
        } else {
            vec3 f = rectangleVector(c, ownBody().sideU.xyz, ownBody().sideV.xyz);
            share = capFormFactor(dot(f, n) / max(length(f), 1e-6), length(f));
            towards = f / max(length(f), 1e-6);
        }
        around = mix(around, lit * ownRadiance(towards), share);
        // Of what is seen of the neighbour the sun is hidden from more than this point: as a wide lobe.
        if (ofPixel(sun.y) > 0.0) sun *= 1.0 - ownShareOf(p, frame.sunDirection.xyz, 0.5).share;
    }
    if (hasLights) around += lightAcross(p, n);
    return around + sun;
}

vec3 lobeOf(vec3 p, vec3 direction, float sigma, float lit) {
    vec3 far = farRadiance(direction, sigma);
    if (!knowsOwn) return far;
    LobeShare met = ownShareOf(p, direction, sigma);
    return met.share < LEAST_SHARE ? far : mix(far, lit * ownRadiance(met.direction), met.share);
}

// What a neighbour sends from its point p towards wo from around the normal n, over a spread of directions.
vec3 neighbourRadiance(NeighbourData o, vec3 p, vec3 wo, vec3 n, float spread, float lit) {
    float alpha = o.base.w;
    ProxyLobe lobe = proxyLobe(wo, n, alpha);
    vec3 fresnel = proxyFresnel(o.f0.xyz, o.f0.w, dot(wo, n), alpha);
    float wide = min(spread, 1.0);
    vec3 sum = o.emission.xyz + lobe.albedo * fresnel * lobeOf(p, lobe.direction, sqrt(lobe.sigma * lobe.sigma + wide * wide), lit);
    vec3 under = vec3(1.0 - max(fresnel.x, max(fresnel.y, fresnel.z)));
    if (glassAround && ofPixel(o.emission.w) > 0.0) {
        float blur = 0.75 * alpha;
        sum += under * under * o.through.xyz * farRadiance(throughBall(wo, n, o.emission.w), sqrt(blur * blur + wide * wide));
    }
    if (ofPixel(max(o.base.x, max(o.base.y, o.base.z))) > 0.0) sum += under * o.base.xyz * irradianceOf(p, n, lit);
    return sum;
}

// A cone of directions spreads by what it turns on a round neighbour, there and back.
float spreadOf(NeighbourData o, LobeShare met) {
    return isSphere(o) ? met.sigma * (1.0 + 2.0 * met.distance / o.centre.w) : met.sigma;
}

LobeShare neighbourShare(NeighbourData o, vec3 centre, vec3 direction, float sigma) {
    if (isSphere(o)) return sphereShare(centre, o.centre.w, direction, sigma);
    if (isTurnedAway(o, centre)) return noShare(direction);
    return rectangleShare(centre, o.sideU.xyz, o.sideV.xyz, direction, sigma);
}

// The environment in what is left of a lobe: its mean and its width, no less than half of the lobe's.
vec3 passedRadiance(Composed c, vec3 direction, float sigma) {
    float left = max(c.passed.y, 0.05);
    vec3 mean = c.mean / left;
    vec3 bent = normalize(mean + 0.05 * direction); // as much of it is left where nearly nothing is
    vec3 moved = bent - direction;
    float variance = clamp(c.squares / left - 0.5 * dot(moved, moved), 0.25 * sigma * sigma, sigma * sigma);
    return c.passed * farRadiance(bent, sqrt(variance));
}

// Radiance that arrives at p, over the horizon of n, by a lobe.
vec3 surroundingRadiance(vec3 p, vec3 n, vec3 direction, float sigma) {
    vec3 sum = vec3(0.0);
    Composed c = nothingTaken(direction, sigma * sigma);
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NeighbourData o = neighbours.each[i];
        LobeShare met = neighbourShare(o, o.centre.xyz - p, direction, sigma);
        c = nextBody(c, o);
        met.share *= lobeIntegral(2.0 * dot(n, met.direction) / max(met.sigma, 0.05));
        if (met.share < LEAST_SHARE) continue;
        sum += c.before * ownShare(c, met.share) * neighbourRadiance(o, p + met.distance * met.direction, -met.direction, met.n, spreadOf(o, met),
                                                                  1.0 - met.share * min(sigma / 0.65, 1.0));
        vec3 moved = met.direction - direction;
        c = withTaken(c, met.share, vec3(0.0), met.direction, met.sigma * met.sigma + 0.5 * dot(moved, moved));
    }
    return sum + passedRadiance(c, direction, sigma);
}

// A ball of glass is a lens: light across wi is drawn together about its axis by a focal length of ior / (2 (ior - 1)) radii from its
// centre, and apart again. What passes it to a point at `centre` from the ball's, over what would without it.
float ballGathers(vec3 centre, float radius, vec3 wi, float ior, float alpha) {
    float focal = ior * radius / max(2.0 * (ior - 1.0), 1e-2);
    float x = dot(centre, wi);
    float paraxial = radius * (x - focal) / focal;
    float rough = 1.5 * alpha * x;
    float width2 = paraxial * paraxial + rough * rough + 0.0625 * radius * radius; // a quarter of the radius: its aberration
    vec3 beside = centre - x * wi;
    return radius * radius / width2 * exp(-dot(beside, beside) / width2);
}

// Of light that comes from `range` metres away (1e30: from afar), what passes all that stands between; sigma: half of its radius.
vec3 passesNeighbours(vec3 p, vec3 wi, float range, float sigma) {
    Composed c = nothingTaken(wi, 0.0);
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NeighbourData o = neighbours.each[i];
        LobeShare met = neighbourShare(o, o.centre.xyz - p, wi, sigma);
        c = nextBody(c, o);
        if (met.share < LEAST_SHARE || met.distance > range) continue;
        vec3 tint = vec3(0.0);
        if (glassAround && ofPixel(o.emission.w) > 0.0) {
            vec3 kept = 1.0 - proxyFresnel(o.f0.xyz, o.f0.w, max(dot(-wi, -met.n), 0.0), o.base.w);
            tint = kept * kept * o.through.xyz;
            if (isSphere(o)) tint *= ballGathers(o.centre.xyz - p, o.centre.w, wi, o.emission.w, o.base.w);
        }
        c = withTaken(c, met.share, tint, wi, 0.0);
    }
    return c.passed;
}

// The length of the mean direction of a cap about n with weight cos: 2/3 of 1 - cos³ over sin².
float capMean(float sin2) {
    float cos2 = max(1.0 - sin2, 0.0);
    return sin2 > 1e-3 ? min((2.0 / 3.0) * (1.0 - cos2 * sqrt(cos2)) / sin2, 1.0) : 1.0;
}

// The mean of what arrives, with weight cos / pi about n.
vec3 surroundingIrradiance(vec3 p, vec3 n) {
    vec3 sum = vec3(0.0);
    Composed c = nothingTaken((2.0 / 3.0) * n, 0.0);
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NeighbourData o = neighbours.each[i];
        vec3 centre = o.centre.xyz - p;
        c = nextBody(c, o);
        float share;
        vec3 towards;
        vec3 met;
        vec3 at;
        float spread;
        float sin2;
        if (isSphere(o)) {
            float range = length(centre);
            if (!(range > 0.8 * o.centre.w)) continue;
            towards = centre / range;
            sin2 = min(o.centre.w * o.centre.w / (range * range), 1.0);
            share = sphereFormFactor(centre, o.centre.w, n) * smoothstep(0.8, 1.0, range / o.centre.w);
            met = -towards;
            at = o.centre.xyz + o.centre.w * met;
            spread = 1.0; // a ball shows all that is around it
        } else {
            if (isTurnedAway(o, centre)) continue;
            vec3 f = rectangleVector(centre, o.sideU.xyz, o.sideV.xyz);
            float size = length(f);
            if (!(size > 0.0)) continue;
            towards = f / size;
            sin2 = size;
            share = capFormFactor(dot(towards, n), size);
            met = normalize(cross(o.sideU.xyz, o.sideV.xyz));
            if (dot(met, towards) > 0.0) met = -met;
            at = p + (dot(centre, met) / min(dot(towards, met), -0.05)) * towards;
            spread = 0.4;
        }
        if (share < LEAST_SHARE) continue;
        sum += c.before * ownShare(c, share) * neighbourRadiance(o, at, -towards, met, spread, 1.0 - share);
        c = withTaken(c, share, vec3(0.0), mix(1.0, capMean(sin2), max(dot(towards, n), 0.0)) * towards, 0.0);
    }
    vec3 sun = sunAcross(n);
    vec3 bent = normalize(c.mean + 0.02 * n);
    sum += c.passed * max(wideRadiance(bent) - sunAcross(bent), vec3(0.0));
    if (ofPixel(sun.y) > 0.0) sum += sun * passesNeighbours(p, frame.sunDirection.xyz, 1e30, frame.sunDirection.w);
    return sum;
}
