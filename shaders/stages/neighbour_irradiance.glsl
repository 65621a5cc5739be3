// neighbour_irradiance.glsl: irradiance past neighbours: the cosine lobe by form factors.
// Frame    world, metres; directions unit.
// Needs    stages/neighbours.glsl and stages/neighbour_shadows.glsl, which include it.
#include "bsdf/constants.glsl"

// Length of the cosine-weighted mean direction of a cap about n: 2/3 of 1 - cos³ over sin²; where that is small 1 - sin²/4, nearly 1.
float capMean(float sin2) {
    float cos2 = max(1.0 - sin2, 0.0);
    return sin2 > 1e-3 ? min((2.0 / 3.0) * (1.0 - cos2 * sqrt(cos2)) / sin2, 1.0) : 1.0;
}

// What of the cosine lobe about a normal a neighbour takes.
struct CosineShare {
    float share;
    vec3 towards; // to the middle of what is met
    float sin2;   // of the angle of the equivalent cap
    vec3 n;       // where it is met
    vec3 at;      // metres, from the receiver
    float spread; // radians: of the directions in which it is seen
};

CosineShare sphereCosineShare(NeighbourData o, vec3 centre, vec3 n) {
    CosineShare s;
    float range = max(length(centre), LEAST_LENGTH * o.centre.w);
    s.towards = centre / range;
    s.sin2 = min(o.centre.w * o.centre.w / (range * range), 1.0);
    s.share = sphereFormFactor(centre, o.centre.w, n) * smoothstep(0.8, 1.0, range / o.centre.w);
    s.n = -s.towards;
    s.at = centre + o.centre.w * s.n;
    s.spread = 1.0; // a ball shows all that is around it
    return s;
}

// The cosine-weighted middle of what lies above the horizon of a cap, from its axis: of a floor that meets a wall pi/2 times as much
// along the wall's normal as down; of a cap that does not reach the horizon its axis.
vec3 aboveHorizon(vec3 axis, float sin2, vec3 n) {
    return normalize(axis + 1.5707963 * max(sqrt(sin2) - dot(axis, n), 0.0) * n + LEAST_LENGTH * n);
}

CosineShare rectangleCosineShare(NeighbourData o, vec3 centre, vec3 n) {
    CosineShare s;
    vec3 f = rectangleVector(centre, o.sideU.xyz, o.sideV.xyz);
    float size = length(f);
    s.towards = f / max(size, LEAST_DIVISOR);
    s.sin2 = size;
    s.share = size > 0.0 && !isTurnedAway(o, centre) ? capFormFactor(dot(s.towards, n), size) : 0.0;
    s.n = normalize(cross(o.sideU.xyz, o.sideV.xyz));
    if (dot(s.n, s.towards) > 0.0) s.n = -s.n;
    s.towards = aboveHorizon(s.towards, size, n);
    s.at = (dot(centre, s.n) / min(dot(s.towards, s.n), -0.05)) * s.towards;
    s.spread = 0.4;
    return s;
}

// The next that takes a share, as nextShare().
struct NextCosineShare {
    int i;
    bool startsBody;
    CosineShare met;
};

NextCosineShare nextCosineShare(int i, vec3 p, vec3 n) {
    NextCosineShare next;
    next.startsBody = false;
    for (next.i = i; next.i < ofPixel(neighbours.counts.x); ++next.i) {
        NeighbourData o = neighbours.each[next.i];
        next.startsBody = next.startsBody || startsBody(o);
        if (isSphere(o)) next.met = sphereCosineShare(o, o.centre.xyz - p, n);
        else next.met = rectangleCosineShare(o, o.centre.xyz - p, n);
        if (!(next.met.share < LEAST_SHARE)) break;
    }
    return next;
}

// The cosine-weighted mean of the radiance that arrives about n. The environment's is looked up about the mean direction of the
// open part. Light through glass comes from about the line through its centre.
vec3 surroundingIrradiance(vec3 p, vec3 n) {
    vec3 sum = vec3(0.0);
    Composed c = nothingTaken();
    vec3 mean = (2.0 / 3.0) * n;
    vec3 through = vec3(0.0);
    vec3 throughMean = vec3(0.0);
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NextCosineShare next = nextCosineShare(i, p, n);
        i = next.i;
        if (i >= ofPixel(neighbours.counts.x)) break;
        if (next.startsBody) c = nextBody(c);
        CosineShare met = next.met;
        NeighbourData o = neighbours.each[i];
        float own = ownShare(c, met.share);
        vec3 arrives = c.before + through; // past all before this one, or through their glass
        sum += arrives * own * neighbourRadiance(o, p + met.at, -met.towards, met.n, met.spread, 1.0 - met.share);
        mean -= c.before.y * own * mix(1.0, capMean(met.sin2), max(dot(met.towards, n), 0.0)) * met.towards;
        through *= 1.0 - own;
        if (isGlass(o)) {
            vec3 passed = arrives * own * passedBy(o, 0.75); // the mean cosine at a ball
            through += passed;
            throughMean += passed.y * met.towards;
        }
        c = withTaken(c, met.share, vec3(0.0));
    }
    vec3 sun = sunAcross(n);
    sum += c.passed * wideWithoutSun(meanOpening(mean, n));
    if (glassAround) sum += through * wideWithoutSun(normalize(throughMean + LEAST_LENGTH * n));
    if (ofPixel(sun.y) > 0.0) sum += sun * passesNeighbours(p, frame.sunDirection.xyz, 1e30, frame.sunDirection.w);
    return sum;
}
