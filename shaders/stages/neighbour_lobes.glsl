// neighbour_lobes.glsl: radiance that arrives by a lobe past neighbours, and through those of glass.
// Frame    world, metres; directions unit.
// Needs    stages/neighbours.glsl, which includes it.
#include "bsdf/constants.glsl"

// The light that all glass neighbours of a lobe pass, as one lobe that leaves them.
struct PassedOn {
    vec3 weight;    // 0: nothing
    vec3 point;     // these three: sums, times `share`
    vec3 direction;
    float variance; // radians²
    float share;
};

PassedOn nothingPassedOn() {
    PassedOn on;
    on.weight = vec3(0.0);
    on.point = vec3(0.0);
    on.direction = vec3(0.0);
    on.variance = 0.0;
    on.share = 0.0;
    return on;
}

// Radians: a proxy's radius is exact to a fiftieth, and the angle of refraction changes by twice that or more, unless the body is a
// ball.
const float UNSURE = 0.05;
const float UNSURE_BALL = 0.02;

// Through a ball, which turns each ray about its axis and spreads a cone by the derivatives of that (stages/neighbour_passed.glsl),
// or straight through a pane. weight: of the lobe that meets it.
PassedOn withPassed(PassedOn on, NeighbourData o, LobeShare met, vec3 p, vec3 weight) {
    vec3 leaves = met.direction;
    vec3 point = met.distance * met.direction;
    float variance = met.sigma * met.sigma;
    float alpha = o.base.w;
    float ior = ofPixel(o.emission.w);
    float c = max(dot(-met.direction, met.n), 0.05);
    float rough;
    if (isSphere(o)) {
        vec3 centre = o.centre.xyz - p;
        float range = length(centre);
        vec3 towardsAxis = -met.n - c * met.direction; // its length is sin of incidence
        // The cone meets the ball at a disc, whose sigma over the ball's radius is added to sin of incidence.
        float disc = met.sigma / asin(min(o.centre.w / range, 0.999));
        c = sqrt(max(c * c - 2.0 * disc * disc, 0.01)); // where the fits end
        float turned = ballDeflection(alpha, ior, c);
        leaves = normalize(met.direction + turned * towardsAxis);
        point = centre + o.centre.w * leaves;
        float cosT = sqrt(1.0 - (1.0 - c * c) / (ior * ior));
        float reach = range / o.centre.w;
        float across = 1.0 - reach * turned;
        float along = 1.0 - 2.0 * reach * (1.0 - c / (ior * cosT)); // cos i cancels: a cone meets the ball at a slant
        variance *= 0.5 * (across * across + along * along);
        rough = ballSigma(alpha, ior, c);
    } else {
        rough = paneSigma(alpha, ior, c);
    }
    float share = weight.y;
    float unsure = ofPixel(o.through.w) > 0.0 ? UNSURE_BALL : UNSURE;
    on.weight += weight * passedBy(o, c);
    on.point += share * (p + point);
    on.direction += share * leaves;
    on.variance += share * (variance + rough * rough + unsure * unsure);
    on.share += share;
    return on;
}

struct OnwardLobe {
    vec3 point;
    vec3 direction;
    float sigma;
};

OnwardLobe onwardLobe(PassedOn on, vec3 n) {
    OnwardLobe lobe;
    lobe.point = on.point / on.share;
    vec3 mean = on.direction / on.share; // shorter than 1 where directions differ
    lobe.direction = normalize(mean + LEAST_LENGTH * n);
    lobe.sigma = sqrt(min(on.variance / on.share + max(1.0 - dot(mean, mean), 0.0), 1.0));
    return lobe;
}

// The next neighbour that takes a share of a lobe, from the place `i` of the list on: devices that run pixels in lockstep
// then shade as often as one pixel has such neighbours, not as often as there are neighbours.
struct NextShare {
    int i; // counts.x: there is none
    bool startsBody;
    LobeShare met;
};

NextShare nextShare(int i, bool opaqueOnly, vec3 p, vec3 n, vec3 direction, float sigma, float least) {
    NextShare next;
    next.startsBody = false;
    next.met = noShare(direction);
    for (next.i = i; next.i < ofPixel(neighbours.counts.x); ++next.i) {
        NeighbourData o = neighbours.each[next.i];
        next.startsBody = next.startsBody || startsBody(o);
        if (opaqueOnly && isGlass(o)) continue;
        next.met = neighbourShare(o, o.centre.xyz - p, direction, sigma);
        next.met.share *= lobeIntegral(2.0 * dot(n, next.met.direction) / max(next.met.sigma, 0.05));
        if (!(next.met.share * (1.0 + max(o.emission.x, max(o.emission.y, o.emission.z))) < least)) break;
    }
    return next;
}

// Radiance that arrives at p, over the horizon of n, by a lobe. The environment's is that of the whole lobe less that of the parts
// that neighbours take, at the parts' own widths, so that no lamp behind a neighbour is seen. Light that glass passes is followed
// once more, to opaque neighbours.
// firstWay: 1 if the lobe is of light that glass has passed. far: of the environment, by all of the lobe, or by several that it
// replaces. least: share below which a neighbour that sends no light of its own is left out.
vec3 radianceFrom(int firstWay, vec3 p, vec3 n, vec3 direction, float sigma, vec3 far, float least) {
    vec3 sum = vec3(0.0);
    vec3 weight = vec3(1.0);
    const int ways = glassAround ? 2 : 1;
    for (int way = firstWay; way < ways; ++way) {
        if (way > 0 && !opaqueAround) {
            sum += weight * far;
            break;
        }
        Composed c = nothingTaken();
        PassedOn on = nothingPassedOn();
        vec3 hidden = vec3(0.0);
        for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
            NextShare next = nextShare(i, way > 0, p, n, direction, sigma, least);
            i = next.i;
            if (i >= ofPixel(neighbours.counts.x)) break;
            if (next.startsBody) c = nextBody(c);
            LobeShare met = next.met;
            NeighbourData o = neighbours.each[i];
            float own = ownShare(c, met.share);
            vec3 taken = weight * c.before * own;
            sum += taken * neighbourRadiance(o, p + met.distance * met.direction, -met.direction, met.n, spreadOf(o, met),
                                             1.0 - met.share * min(sigma / 0.65, 1.0));
            if (isGlass(o)) on = withPassed(on, o, met, p, taken);
            hidden += c.before * own * farRadiance(met.direction, partSigma(met, sigma));
            c = withTaken(c, met.share, vec3(0.0));
        }
        sum += weight * farLeft(far, hidden, c.passed.y);
        if (!(on.share > 0.0)) break;
        OnwardLobe onward = onwardLobe(on, n);
        weight = on.weight;
        p = onward.point;
        direction = onward.direction;
        n = direction;
        sigma = onward.sigma;
        far = farRadiance(direction, sigma);
    }
    return sum;
}

vec3 surroundingRadiance(vec3 p, vec3 n, vec3 direction, float sigma, vec3 far, float least) {
    return radianceFrom(0, p, n, direction, sigma, far, least);
}
