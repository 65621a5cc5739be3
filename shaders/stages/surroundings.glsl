// surroundings.glsl: radiance of a lobe that leaves glass: from the scene-colour pyramid where its intersection is on the picture,
// else from the environment at the same width.
// Frame    world, metres; pixels from the top left corner.
// Needs    interface/frame.glsl, stages/neighbours.glsl.
// Source   a screen-space ray march in the depth behind the layer. First fixed-point steps: each depth that was read is taken for a
//          plane across the view, which the lobe mean intersects in closed form; walls and floors take two or three reads. Where
//          that does not converge, steps that are even on the screen [McGuireMara14], then secants.
#include "bsdf/constants.glsl"
#include "stages/of_pixel.glsl"
#include "stages/picture_pixel.glsl"
#include "refraction/lobe_stratum.glsl"
#include "refraction/screen_pyramid_fetch.glsl"

layout(binding = 24) uniform sampler2D screenPyramid;
layout(binding = 25) uniform sampler2D sceneCopyDepth; // device depth: 1 near, 0 far and sky

// A Gaussian lobe that leaves the glass; see ComposedLobe.
struct LobeRay {
    vec3 origin;
    vec3 direction;
    float sigma;   // radians
    float inner;   // sigma that it had inside, radians
    float carried; // of sigma, what came with it
    float inside;  // metres that it ran inside
    float turn;    // variance of its direction over what is seen of the pixel, radians²: part of every lookup, not of the light
};

// A lobe that comes from a point, not from within glass.
LobeRay lobeRay(vec3 origin, vec3 direction, float sigma) {
    LobeRay lobe;
    lobe.origin = origin;
    lobe.direction = direction;
    lobe.sigma = sigma;
    lobe.inner = 0.0;
    lobe.carried = 0.0;
    lobe.inside = 0.0;
    lobe.turn = 0.0;
    return lobe;
}

// There are few strata, and each draws an outline of what it meets; the same strata in all pixels would draw these as lines. So
// each pixel turns its strata about the lobe mean, by up to half of the angle between two of them: N strata are 2 pi / N apart, and
// frame.part.w is 1 / (12 N). Angles from a lattice of the plastic number's powers differ most between adjacent pixels.
mat2 pixelTurn() {
    float angle = 48.0 * BSDF_PI * frame.part.w * (fract(dot(vec2(picturePixel()), vec2(0.754877666, 0.569840291))) - 0.5);
    return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

// A stratum of a lobe (refraction/lobe_stratum.glsl).
LobeRay stratumOf(LobeRay lobe, vec3 stratum) {
    LobeStratum own = lobeStratum(lobe.direction, lobe.sigma, lobe.inner, lobe.carried, stratum);
    lobe.origin += lobe.inside * own.aside;
    lobe.direction = own.direction;
    lobe.sigma = own.sigma;
    lobe.inner = own.inner;
    lobe.carried = own.carried;
    return lobe;
}

// The stratum of a lobe that this sample of the pixel takes. A wide lobe meets more than one thing: each stratum finds its own
// intersection, where a single one would draw a sharp outline.
vec3 ownStratum() { return vec3(pixelTurn() * frame.part.xy, frame.part.z); }

LobeRay partOf(LobeRay lobe) { return stratumOf(lobe, ownStratum()); }

// Where a pixel has fewer samples than this a wide lobe takes as many strata in each of them.
const int WIDE_STRATA = 8;
const int OUTLINE_PAIRS = 4;
bool hasFewSamples() { return ofPixel(frame.part.w) * float(12 * WIDE_STRATA) > 1.0; }

// The k-th of them, sqrt(.5) as wide as the lobe, one sigma off its mean: together they have its mean and variance. Level and
// upright edges cross no two at once. Samples of a pixel turn them.
vec3 wideStratum(int k) {
    vec2 part = vec2(ofPixel(frame.part.x), frame.part.y);
    float own = dot(part, part) > 0.0 ? atan(part.y, part.x) / float(WIDE_STRATA) : 0.0;
    float turn = 0.21 + own + float(k) * (2.0 * BSDF_PI / float(WIDE_STRATA));
    return vec3(cos(turn), sin(turn), 0.70711);
}

// Where a lobe mean meets the depth behind the layer.
struct Intersection {
    float distance; // metres from the origin; negative: nowhere, it goes to the sky
    bool seen;      // the picture shows it
    float foreshortening; // area that the picture shows of a patch of the surface, over the area that the lobe does
    bool hidden;    // behind something nearer, from there on
    vec2 from;      // pixels: where the lobe begins
    bool guessed;   // the picture does not show that place: its border is extended
    float wall;     // the share of the lobe that meets a planar proxy; 0: none
};

layout(constant_id = 54) const bool hasWalls = true; // the frame has planar proxies

const float OUTSIDE_FADE = 1.0; // of the picture's height
const int INTERSECTION_GUESSES = 4;
const int INTERSECTION_STEPS = 12;
const int INTERSECTION_SECANTS = 6;
const int INTERSECTION_READS = 26; // steps, and two crossings

// Clip coordinates, w > 0 -> pixels.
vec2 pixelOf(vec4 clip) { return (vec2(0.5, -0.5) * clip.xy / clip.w + 0.5) * frame.picture.xy; }

float depthBehind(vec2 at) {
    return texelFetch(sceneCopyDepth, ivec2(clamp(at, vec2(0.0), frame.picture.xy - 1.0)), 0).x;
}

// How far along the ray from `from` (clip coordinates; `along` per metre) the depth is z: negative if never.
float distanceToDepth(vec4 from, vec4 along, float z) {
    float rate = along.z - z * along.w;
    return rate == 0.0 ? -1.0 : (z * from.w - from.z) / rate;
}

// Metres until the ray leaves the bounds of the scene.
float distanceOutOfScene(vec3 origin, vec3 direction) {
    vec3 inverse = 1.0 / direction; // infinite along an axis that it does not move on, which min and max take
    vec3 far = max((frame.boundsLow.xyz - origin) * inverse, (frame.boundsHigh.xyz - origin) * inverse);
    return min(far.x, min(far.y, far.z));
}

Intersection nowhere() {
    Intersection m;
    m.distance = -1.0;
    m.seen = false;
    m.foreshortening = 1.0;
    m.hidden = false;
    m.from = vec2(0.0);
    m.guessed = true;
    m.wall = 0.0;
    return m;
}

// Even steps on the screen are even in 1 / w: the fraction of the ray at a fraction v of its way on the screen.
float wayAlong(float v, float wFrom, float wTo) {
    float near = (1.0 - v) / wFrom;
    float far = v / wTo;
    return far / (near + far);
}

// The surface at a pixel, seen along the view and along the lobe: the ratio of the two cosines. A plane in the world is a plane in
// device depth. Of the two differences of four texels along each axis the one that is less far in depth belongs to one surface.
float foreshorteningAt(vec2 at, vec3 direction) {
    vec2 centre = floor(clamp(at, vec2(1.0), frame.picture.xy - 1.0) + 0.5); // where four meet
    vec4 four = textureGather(sceneCopyDepth, centre / frame.picture.xy);     // below left, below right, above right, above left
    float z = four.w;
    float above = four.z - four.w;
    float below = four.y - four.x;
    float left = four.x - four.w;
    float right = four.y - four.z;
    vec2 perPixel = vec2(abs(above) < abs(below) ? above : below, abs(left) < abs(right) ? left : right);
    centre -= 0.5;
    vec2 perClip = vec2(0.5, -0.5) * frame.picture.xy * perPixel;
    vec2 clip = vec2(2.0, -2.0) * (centre / frame.picture.xy - 0.5);
    vec4 plane = vec4(perClip, -1.0, z - dot(perClip, clip)); // dot(plane, clip coordinates) = 0
    vec3 n = (plane * frame.clipFromWorld).xyz;
    vec4 p = frame.worldFromClip * vec4(clip, z, 1.0);
    vec3 view = ofPixel(frame.eye.w) > 0.0 ? normalize(p.xyz / p.w - frame.eye.xyz) : frame.viewDirection.xyz;
    // For a grazing lobe the footprint on the surface has no bound; past a factor of 16 the environment is looked up.
    float seen = abs(dot(n, view));
    float met = abs(dot(n, direction));
    return clamp(seen / max(met, LEAST_DIVISOR), 1.0 / 16.0, 16.0);
}

// Fixed-point steps: the depth that was read is taken for a plane across the view, and read again where the lobe mean intersects
// it. True if that converges.
Intersection guessIntersection(vec4 from, vec4 along) {
    Intersection guess = nowhere();
    vec2 at = pixelOf(from);
    for (int k = 0; k < INTERSECTION_GUESSES && !guess.seen; ++k) {
        float z = depthBehind(at);
        bool sky = z == 0.0;
        float met = sky ? -1.0 : distanceToDepth(from, along, z);
        vec4 there = sky ? along : from + met * along;
        if (!((sky || met >= 0.0) && there.w > 0.0)) break;
        // Off the picture its border is extended (depthBehind): the picture's share of the lobe fades out there.
        vec2 next = pixelOf(there);
        vec2 moved = abs(next - at);
        at = next;
        // Within a pixel the depth that was read is the depth there.
        guess.seen = k > 0 && max(moved.x, moved.y) < 1.0;
        guess.distance = met;
    }
    guess.guessed = any(lessThan(at, vec2(0.0))) || any(greaterThan(at, frame.picture.xy));
    return guess;
}

// The share of the way of a lobe that the picture can show: to the end of the scene, as far as it stays on the picture and before
// the camera. Each clip plane x = ±w, y = ±w and w = a hundredth of where it began cuts off what lies beyond.
float wayOnPicture(vec4 from, vec4 way) {
    vec4 room = max(vec4(from.w - from.x, from.w + from.x, from.w - from.y, from.w + from.y), vec4(0.0));
    vec4 loss = vec4(way.x - way.w, -way.x - way.w, way.y - way.w, -way.y - way.w);
    vec4 cut = min(room / max(max(loss, room), vec4(LEAST_DIVISOR)), vec4(1.0)); // 1 where nothing is cut
    float end = min(min(cut.x, cut.y), min(cut.z, cut.w));
    return min(end, 0.99 * from.w / max(-way.w, 0.99 * from.w));
}

// In steps that are even on the screen, a pixel long at least, and closing in where one went behind the depth.
Intersection stepToIntersection(vec4 from, vec4 along, float most) {
    vec4 way = most * along;
    float end = wayOnPicture(from, way);
    vec4 to = from + end * way;
    vec3 a = from.xyz / from.w;
    vec3 b = to.xyz / to.w;
    vec2 pixels = 0.5 * abs(b.xy - a.xy) * frame.picture.xy;
    int steps = int(clamp(ceil(max(pixels.x, pixels.y)), 1.0, float(INTERSECTION_STEPS)));

    Intersection met = nowhere();
    int step = -1;  // the height at the start is not known yet
    int secant = 0; // > 0: between low (in front) and high (behind)
    float low = 0.0;
    float heightLow = 0.0;
    float high = 0.0;
    float heightHigh = 0.0;
    float gap = 0.0;     // of the heights where the crossing was noticed
    float last = 0.0;    // height at the step before
    float hidden = -1.0; // where it went behind something
    for (int k = 0; k < INTERSECTION_READS && !met.seen; ++k) {
        bool closing = secant > 0;
        // Bisection first: at a step in depth between the two ends a secant would stay at one of them.
        float share = (secant & 1) == 0 ? heightLow / (heightLow - heightHigh) : 0.5;
        float u = closing ? mix(low, high, share) : float(step + 1) / float(steps);
        vec3 ndc = mix(a, b, u);
        float height = ndc.z - depthBehind((vec2(0.5, -0.5) * ndc.xy + 0.5) * frame.picture.xy); // above the surface: positive
        if (closing) {
            ++secant;
            bool front = height >= 0.0;
            low = front ? u : low;
            heightLow = front ? height : heightLow;
            high = front ? high : u;
            heightHigh = front ? heightHigh : height;
            float rest = min(heightLow, -heightHigh);
            // At a surface the heights converge to 0. At an edge they do not: the ray went behind something nearer.
            bool given = secant > INTERSECTION_SECANTS;
            met.seen = rest < 0.02 * gap || (given && rest < 0.1 * gap);
            met.distance = most * end * wayAlong(mix(low, high, heightLow / max(heightLow - heightHigh, LEAST_DIVISOR)), from.w, to.w);
            hidden = given ? low : hidden;
            secant = given ? 0 : secant;
        } else {
            ++step;
            bool crossed = step > 0 && last >= 0.0 && height < 0.0;
            secant = crossed ? 1 : 0;
            low = float(step - 1) / float(steps);
            heightLow = last;
            high = u;
            heightHigh = height;
            gap = last - height;
            last = height;
        }
        if (secant == 0 && step == steps) break;
    }
    if (!met.seen) {
        bool front = last >= 0.0;
        // It ends behind something: the colour beside that is the best guess, and continuous. In front where it leaves the
        // picture: the border is extended. Else there is no intersection: the sky, where the picture shows it.
        bool behind = !front && hidden >= 0.0;
        float z = b.z - last;
        bool bordered = front && end < 1.0 && z > 0.0;
        met.distance = behind ? most * end * wayAlong(hidden, from.w, to.w) : bordered ? distanceToDepth(from, along, z) : -1.0;
        bool sky = front && along.w > 0.0 && (end < 1.0 ? z <= 0.0 : depthBehind(pixelOf(along)) == 0.0);
        met.seen = behind || (bordered ? met.distance >= 0.0 : sky);
        met.hidden = behind;
        met.guessed = !behind && !(sky && !bordered && end == 1.0);
    } else {
        met.guessed = false;
    }
    return met;
}

// How much of a Gaussian about x falls between -1 and 1.
float betweenEdges(float x, float sigma) {
    float inverse = 1.0 / max(sigma, LEAST_LENGTH); // as sharp as floats know a place
    return max(normalIntegral((1.0 - x) * inverse) - normalIntegral((-1.0 - x) * inverse), 0.0);
}

// Of the planar proxies, on the picture or not, the one that takes most of the lobe: x its share, y metres. Positions are exact to
// a millionth of their distance: within ten of that the lobe starts on the proxy.
vec2 meetWalls(vec3 origin, vec3 direction, float sigma) {
    vec2 most = vec2(0.0, -1.0);
    for (int i = 0; i < ofPixel(frame.counts.y); ++i) {
        vec3 apart = frame.walls[3 * i].xyz - origin;
        vec3 u = frame.walls[3 * i + 1].xyz;
        vec3 v = frame.walls[3 * i + 2].xyz;
        vec3 n = cross(u, v);
        float height = dot(apart, n);
        float towards = dot(direction, n);
        float met = height / towards; // infinite along the wall, which misses it
        bool starts = height * height < 1e-10 * dot(n, n) * dot(apart, apart);
        if (starts || !(met > 0.0 && met < 1e30)) continue;
        vec3 off = met * direction - apart;
        // The spot's mean width on the wall: 1 / cosine longer along the lobe.
        float width = met * sigma * inversesqrt(max(abs(towards) * inversesqrt(dot(n, n)), LEAST_LENGTH));
        float share = betweenEdges(dot(off, u), width * length(u)) * betweenEdges(dot(off, v), width * length(v));
        if (share > most.x) most = vec2(share, met);
    }
    return most;
}

// sigma: the lobe's, radians. `guess`: depth to depth first; not where the ray starts from a surface that is in the depth.
Intersection intersectScene(vec3 origin, vec3 direction, float sigma, bool guess) {
    vec4 from = frame.clipFromWorld * vec4(origin, 1.0);
    vec4 along = frame.clipFromWorld * vec4(direction, 0.0);
    Intersection met = nowhere();
    if (!(from.w > 0.0)) return met;
    if (guess) met = guessIntersection(from, along);
    // A proxy may lie on the bounds of the scene: a fiftieth further.
    if (!met.seen) met = stepToIntersection(from, along, 1.02 * max(distanceOutOfScene(origin, direction), 0.0));
    if (hasWalls && met.guessed) {
        vec2 wall = meetWalls(origin, direction, sigma);
        if (wall.x > 0.004) { // a step of 8 bits

            // A point behind the camera has no position on the picture: the ray leaves the picture on the way there.
            met.distance = min(wall.y, 0.99 * from.w / max(-along.w, LEAST_DIVISOR));
            met.seen = true;
            met.wall = wall.x;
        }
    }
    vec2 at = pixelOf(from + met.distance * along);
    met.from = guess ? pixelOf(from) : at; // a reflecting surface is on the picture itself: it is not read
    if (met.seen && met.distance > 0.0) met.foreshortening = foreshorteningAt(at, direction);
    return met;
}

float seenSigma(LobeRay lobe) { return sqrt(lobe.sigma * lobe.sigma + lobe.turn); }

// Where a lobe falls on the picture, and how much of it does.
struct Footprint {
    vec2 at;        // pixels
    float variance; // pixels²
    float outside;  // of that, pixels²: because it is not on the picture
    float share;    // 0: the picture does not show it
};

// `intersection`: of the lobe's centre, or of another lobe of nearly the same origin and direction.
Footprint footprintOf(LobeRay lobe, Intersection intersection) {
    Footprint f;
    f.at = vec2(0.0);
    f.variance = 0.0;
    f.outside = 0.0;
    f.share = 0.0;
    bool ends = intersection.distance >= 0.0;
    vec4 place = ends ? vec4(lobe.origin + intersection.distance * lobe.direction, 1.0) : vec4(lobe.direction, 0.0);
    vec4 clip = frame.clipFromWorld * place;
    if (!(intersection.seen && clip.w > 0.0)) return f;
    vec3 fromEye = ends ? place.xyz - frame.eye.xyz : lobe.direction;
    float range = length(fromEye);
    float apart = intersection.distance * intersection.distance * lobe.turn;
    float metres =
        ends ? sqrt(lobeVariance(lobe.sigma, lobe.carried, lobe.inner, lobe.inside, intersection.distance) + apart) : 0.0;
    float pixels; // sigma
    if (ofPixel(frame.eye.w) > 0.0) {
        pixels = (ends ? metres / range : seenSigma(lobe)) * pixelsPerRadian(frame.picture.z, min(clip.w / range, 1.0));
    } else {
        // An orthographic camera sees one direction of the sky only: the environment is looked up for the others.
        pixels = metres * frame.picture.z;
    }
    pixels *= sqrt(intersection.foreshortening);
    vec2 at = pixelOf(clip);
    // Beside the occluder that hides the rest of the ray, a blur would take half of its light from the occluder, which may be a
    // highlight: it is read two sigma back along the ray, at most where the ray begins.
    if (intersection.hidden) {
        vec2 back = intersection.from - at;
        at += back * min(4.0 * pixels * pixels / max(dot(back, back), LEAST_LENGTH), 1.0); // a thousandth of a pixel is no way
    }
    // Off the picture the sky comes from the environment. Surfaces are extended from the border, ever more blurred, and fade over
    // the picture's height; planar proxies do not fade.
    vec2 outside = max(max(-at, at - frame.picture.xy), vec2(0.0)) / (OUTSIDE_FADE * frame.picture.y);
    f.share = ends ? exp(-0.5 * dot(outside, outside)) : pyramidCoverage(at, frame.picture.xy, pixels);
    if (intersection.wall > 0.0) f.share = intersection.wall;
    outside *= OUTSIDE_FADE * frame.picture.y;
    f.at = at;
    f.outside = dot(outside, outside);
    f.variance = pixels * pixels + f.outside;
    return f;
}

// Radiance from the pyramid, and in w the share of the lobe that it covers. Where less than half of the blur falls on what can be
// behind the layer, the environment fills the rest.
vec4 pictureRadiance(Footprint f) {
    if (!(f.share > 0.0)) return vec4(0.0);
    vec4 seen = fetchPyramid(screenPyramid, f.at, frame.picture.xy, f.variance, frame.picture.w);
    return vec4(seen.w > 0.0 ? seen.xyz / seen.w : vec3(0.0), f.share * min(2.0 * seen.w, 1.0));
}

// Radiance that arrives along the lobe.
vec3 lobeRayRadiance(LobeRay lobe, Intersection intersection) {
    vec4 near = pictureRadiance(footprintOf(lobe, intersection));
    if (near.w >= 0.999) return near.xyz; // the rest, a thousandth, is below a step of 8 bits
    return mix(farRadiance(lobe.direction, seenSigma(lobe)), near.xyz, near.w);
}

// Of a lobe's light, what is left to its strata where the picture's depth, one sigma off its mean, is not that of one plane, over
// which depth is linear: on one plane they meet what the mean meets. at, sigma: pixels. nearer: the way from the glass over that
// from the eye.
const float ONE_PLANE = 0.005;
const float TWO_THINGS = 0.02;
float apartShare(vec2 at, float sigma, float nearer) {
    float z = depthBehind(at);
    float least = z;
    float bent = 0.0;
    for (int k = 0; k < OUTLINE_PAIRS; ++k) {
        float turn = 0.21 + float(k) * (BSDF_PI / float(OUTLINE_PAIRS));
        vec2 aside = floor(sigma * vec2(cos(turn), sin(turn)) + 0.5); // to texels as far to one side as to the other
        vec2 within = min(at, frame.picture.xy - at) - abs(aside);
        if (min(within.x, within.y) < 0.0) continue; // extended borders bend
        float one = depthBehind(at + aside);
        float other = depthBehind(at - aside);
        bent = max(bent, abs(0.5 * (one + other) - z));
        least = max(least, max(one, other));
    }
    return smoothstep(ONE_PLANE, TWO_THINGS, bent / max(least * nearer, LEAST_DIVISOR));
}

// How much of a lobe's light its strata bring: from sigmas on the picture of 1.5 pixels, where an outline is as sharp as its blur,
// to 3. `intersection`: of the lobe's mean.
const float WIDE_FROM = 1.5;
const float WIDE_TO = 3.0;

// What is no wider than that where it starts is not either where it ends: an orthographic camera, which sees metres, apart.
float wideShare(LobeRay lobe, Intersection intersection) {
    if (isSmooth || !hasFewSamples() || (lobe.sigma * frame.picture.z < WIDE_FROM && ofPixel(frame.eye.w) > 0.0)) return 0.0;
    // Over the glass, in pixels: where a face turns so fast its lobes differ more from pixel to pixel than they are wide.
    float onGlass = lobe.sigma * sqrt(frame.part.w / max(lobe.turn, LEAST_LENGTH2));
    lobe.turn = 0.0; // what the pixel adds is no part of the lobe
    Footprint f = footprintOf(lobe, intersection);
    if (!(f.share > 0.0)) f.at = intersection.from;
    float sigma = f.share > 0.0 ? sqrt(f.variance - f.outside) : lobe.sigma * frame.picture.z;
    float wide = smoothstep(WIDE_FROM, WIDE_TO, min(sigma, onGlass));
    float range = length(lobe.origin + intersection.distance * lobe.direction - frame.eye.xyz);
    return wide * apartShare(f.at, sigma, intersection.distance > 0.0 ? min(intersection.distance / range, 1.0) : 1.0);
}

vec3 stratumAt(int k) { return k == 0 ? ownStratum() : wideStratum(k - 1); }
