// neighbour_groups.glsl: radiance that arrives past neighbours by several lobes beside each other, as those of one brushed surface.
// Shares and the environment past neighbours are those of each lobe; a neighbour is shaded once for the whole group, at the mean of
// the places where its lobes meet it.
// Frame    world, metres; directions unit.
// Needs    stages/neighbours.glsl.
#include "bsdf/constants.glsl"

// What all lobes of a group meet of one neighbour; all but `weight` are sums, times weight.
struct GroupShare {
    float weight;
    vec3 direction;
    float variance; // radians²
    float distance;
    vec3 n;
    float kept; // 1 - lit of neighbourRadiance()
};

struct LobeGroup {
    vec3 far; // sum of what arrives past the neighbours
    float weight;
    GroupShare met[MOST_NEIGHBOURS];
};

LobeGroup emptyGroup() {
    LobeGroup g;
    g.far = vec3(0.0);
    g.weight = 0.0;
    if (neighbourKinds != 0) {
        for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
            g.met[i].weight = 0.0;
            g.met[i].direction = vec3(0.0);
            g.met[i].variance = 0.0;
            g.met[i].distance = 0.0;
            g.met[i].n = vec3(0.0);
            g.met[i].kept = 0.0;
        }
    }
    return g;
}

// As surroundingRadiance() takes the environment, for one lobe.
void addLobe(inout LobeGroup g, Surface s, float weight, vec3 direction, float sigma) {
    vec3 far = farRadiance(direction, sigma);
    g.weight += weight;
    if (neighbourKinds == 0) {
        g.far += weight * far;
        return;
    }
    vec3 hidden = vec3(0.0);
    Composed c = nothingTaken();
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        NextShare next = nextShare(i, false, s.position, s.n, direction, sigma, LEAST_SHARE);
        i = next.i;
        if (i >= ofPixel(neighbours.counts.x)) break;
        if (next.startsBody) c = nextBody(c);
        LobeShare met = next.met;
        float own = c.before.y * ownShare(c, met.share);
        hidden += own * farRadiance(met.direction, partSigma(met, sigma));
        float w = weight * own;
        g.met[i].weight += w;
        g.met[i].direction += w * met.direction;
        g.met[i].variance += w * met.sigma * met.sigma;
        g.met[i].distance += w * met.distance;
        g.met[i].n += w * met.n;
        g.met[i].kept += w * met.share * min(sigma / 0.65, 1.0);
        c = withTaken(c, met.share, vec3(0.0));
    }
    g.far += weight * farLeft(far, hidden, c.passed.y);
}

vec3 groupRadiance(LobeGroup g, Surface s) {
    vec3 sum = g.far;
    if (neighbourKinds == 0) return sum;
    PassedOn on = nothingPassedOn();
    for (int i = 0; i < ofPixel(neighbours.counts.x); ++i) {
        GroupShare m = g.met[i];
        if (!(m.weight > LEAST_SHARE * g.weight)) continue; // nor where no lobe of the group has a weight
        NeighbourData o = neighbours.each[i];
        LobeShare met;
        met.share = m.weight;
        vec3 mean = m.direction / m.weight; // shorter than 1 by half of what directions scatter, squared
        met.direction = normalize(mean);
        met.sigma = sqrt(m.variance / m.weight + 0.5 * max(1.0 - dot(mean, mean), 0.0));
        met.distance = m.distance / m.weight;
        met.n = normalize(m.n + LEAST_LENGTH * met.direction);
        sum += m.weight * neighbourRadiance(o, s.position + met.distance * met.direction, -met.direction, met.n, spreadOf(o, met),
                                            1.0 - m.kept / m.weight);
        if (isGlass(o)) on = withPassed(on, o, met, s.position, vec3(m.weight));
    }
    if (glassAround) {
        if (ofPixel(on.share) > 0.0) {
            OnwardLobe onward = onwardLobe(on, s.n);
            vec3 far = farRadiance(onward.direction, onward.sigma);
            sum += on.weight *
                   radianceFrom(1, onward.point, onward.direction, onward.direction, onward.sigma, far, LEAST_SHARE);
        }
    }
    return sum;
}
