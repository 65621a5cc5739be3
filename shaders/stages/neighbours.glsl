// neighbours.glsl: light that arrives past neighbours: their radiance for the share of a lobe that they take, the environment for
// the rest.
// Frame    world, metres; directions unit.
// Needs    interface/frame.glsl, stages/environment.glsl, stages/material_features.glsl.
// Source   neighbours/lobe_share.glsl, neighbours/form_factor.glsl; each neighbour by its own material, lit by the environment
//          alone: one bounce. Front to back in the order of the list; the faces of one box lie beside each other.
#include "bsdf/constants.glsl"
#include "interface/neighbours.glsl"
#include "neighbours/form_factor.glsl"
#include "neighbours/lobe_share.glsl"
#include "neighbours/proxy_lobe.glsl"
#include "stages/far_radiance.glsl"
#include "stages/light_arrival.glsl"
#include "stages/neighbour_passed.glsl"

const bool spheresAround = (neighbourKinds & 1) != 0;
const bool rectanglesAround = (neighbourKinds & 2) != 0;
const bool glassAround = (neighbourKinds & 4) != 0;
const bool opaqueAround = (neighbourKinds & 8) != 0;
const float LEAST_SHARE = 0.004; // a step of 8 bits

bool isGlass(NeighbourData o) { return glassAround && ofPixel(o.emission.w) > 0.0; }

bool isSphere(NeighbourData o) { return spheresAround && (!rectanglesAround || ofPixel(o.centre.w) > 0.0); }

// The faces of a box are one-sided.
bool isTurnedAway(NeighbourData o, vec3 centre) { return ofPixel(o.sideU.w) > 0.0 && dot(cross(o.sideU.xyz, o.sideV.xyz), centre) >= 0.0; }

// Front to back: the share that each body takes of what those in front of it leave.
struct Composed {
    vec3 before; // that passes all bodies before this one
    float taken; // by this body
    vec3 passed;
};

Composed nothingTaken() {
    Composed c;
    c.before = vec3(1.0);
    c.taken = 0.0;
    c.passed = vec3(1.0);
    return c;
}

Composed nextBody(Composed c) {
    c.before = c.passed;
    c.taken = 0.0;
    return c;
}

// Of two rectangles of one body the second continues the first: what one covers the other does not.
bool startsBody(NeighbourData o) { return !(ofPixel(o.sideV.w) > 0.0); }

float ownShare(Composed c, float share) { return min(share, 1.0 - c.taken); }

// `tint` of what it takes passes.
Composed withTaken(Composed c, float share, vec3 tint) {
    float own = ownShare(c, share);
    c.taken += own;
    c.passed -= c.before * own * (1.0 - tint);
    return c;
}

// The share of its neighbours' light that the receiver's own body occludes, and the light that it sends them: one more reflection
// between the two.
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

// A sun in the environment is a light apart.
vec3 sunAcross(vec3 n) { return frame.sunIrradiance.xyz * (max(dot(n, frame.sunDirection.xyz), 0.0) / BSDF_PI); }

vec3 wideWithoutSun(vec3 n) { return max(wideRadiance(n) - sunAcross(n), vec3(0.0)); }

// Mean direction of the open part of a cosine lobe; n where hardly any is open.
vec3 meanOpening(vec3 mean, vec3 n) { return normalize(mean + 0.02 * n); }

// lit: how much of its light the receiver keeps when the neighbour has taken its share of it.
vec3 irradianceOf(vec3 p, vec3 n, float lit) {
    vec3 sun = sunAcross(n);
    vec3 around = vec3(0.0);
    vec3 open = n;
    float share = 0.0;
    if (knowsOwn) {
        vec3 c = ownBody().centre.xyz - p;
        vec3 towards;
        if (ownIsSphere) {
            share = sphereFormFactor(c, ownBody().centre.w, n);
            towards = normalize(c);
        } else {
            vec3 f = rectangleVector(c, ownBody().sideU.xyz, ownBody().sideV.xyz);
            share = capFormFactor(dot(f, n) / max(length(f), LEAST_LENGTH), length(f));
            towards = f / max(length(f), LEAST_LENGTH);
        }
        open = meanOpening((2.0 / 3.0) * n - share * towards, n); // the body as a narrow cap
        around = share * lit * ownRadiance(towards);
        // Of what is seen of the neighbour the sun is hidden from more than this point: as a wide lobe.
        if (ofPixel(sun.y) > 0.0) sun *= 1.0 - ownShareOf(p, frame.sunDirection.xyz, 0.5).share;
    }
    around += (1.0 - share) * wideWithoutSun(open);
    if (hasLights) around += lightAcross(p, n);
    return around + sun;
}

// Width of the part that a neighbour takes of a lobe: the product of two Gaussians, the lobe and what it meets.
float partSigma(LobeShare met, float sigma) {
    return met.sigma * sigma * inversesqrt(max(met.sigma * met.sigma + sigma * sigma, LEAST_LENGTH2));
}

// The environment by what is left of a lobe of which `passed` is not taken: all of it without the hidden parts, and of a lobe that
// is nearly taken no more than four times what is left, as the parts' Gaussians and the lobe's agree to some percent only.
vec3 farLeft(vec3 far, vec3 hidden, float passed) { return clamp(far - hidden, vec3(0.0), min(4.0 * passed, 1.0) * far); }

vec3 lobeOf(vec3 p, vec3 direction, float sigma, float lit) {
    vec3 far = farRadiance(direction, sigma);
    if (!knowsOwn) return far;
    LobeShare met = ownShareOf(p, direction, sigma);
    if (met.share < LEAST_SHARE) return far;
    // Without the part that the body hides, at that part's own width: a lamp behind the body is not seen through it.
    vec3 hidden = met.share * farRadiance(met.direction, partSigma(met, sigma));
    return farLeft(far, hidden, 1.0 - met.share) + met.share * lit * ownRadiance(met.direction);
}

// What a neighbour sends from its point p towards wo from around the normal n, over a spread of directions.
vec3 neighbourRadiance(NeighbourData o, vec3 p, vec3 wo, vec3 n, float spread, float lit) {
    float alpha = o.base.w;
    ProxyLobe lobe = proxyLobe(wo, n, alpha);
    vec3 fresnel = proxyFresnel(o.f0.xyz, o.f0.w, dot(wo, n), alpha);
    float wide = min(spread, 1.0);
    vec3 sum = o.emission.xyz + lobe.albedo * fresnel * lobeOf(p, lobe.direction, sqrt(lobe.sigma * lobe.sigma + wide * wide), lit);
    vec3 under = vec3(1.0 - max(fresnel.x, max(fresnel.y, fresnel.z)));
    if (opaqueAround && ofPixel(max(o.base.x, max(o.base.y, o.base.z))) > 0.0) sum += under * o.base.xyz * irradianceOf(p, n, lit);
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

// The transmittance of glass at a cosine to its normal, of light that leaves where it first meets the far face.
vec3 passedBy(NeighbourData o, float cosine) {
    vec3 kept = 1.0 - proxyFresnel(o.f0.xyz, o.f0.w, cosine, 0.0);
    return kept * kept * passedShare(o.base.w, ofPixel(o.emission.w), cosine) * o.through.xyz;
}

#include "stages/neighbour_shadows.glsl"
#include "stages/neighbour_lobes.glsl"
#include "stages/neighbour_irradiance.glsl"
