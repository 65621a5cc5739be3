// surroundings.glsl: what a beam of light that leaves the glass brings: the picture behind it where it can be seen, the
// environment at the same width where it cannot.
// Frame    world, metres; pixels from the top left corner.
// Needs    interface/frame.glsl, stages/environment.glsl.
// Source   DESIGN.md §2 (5). A surface that a beam meets is looked for in the depth behind the layer: first from depth to
//          depth (each read is taken for a plane across the view, whose meeting with the beam has a closed form), which finds
//          walls and floors in two or three reads; where that does not settle, in steps that are even on the screen.
#include "refraction/screen_pyramid_fetch.glsl"

layout(binding = 24) uniform sampler2D screenPyramid;
layout(binding = 25) uniform sampler2D backdropDepth; // device depth: 1 near, 0 far and sky

// A Gaussian beam that leaves the glass; see ComposedTap.
struct Beam {
    vec3 origin;
    vec3 direction;
    float sigma;   // radians
    float inner;   // sigma that it had inside, radians
    float carried; // of sigma, what came with it
    float inside;  // metres that it ran inside
};

// Where a beam's centre meets what is behind.
struct Meeting {
    float distance; // metres from the origin; negative: nowhere, it goes to the sky
    bool seen;      // the picture shows it
    float foreshortening; // area that the picture shows of a patch of the surface, over the area that the beam does
};

const float OUTSIDE_FADE = 1.0; // of the picture's height
const int MEETING_GUESSES = 4;
const int MEETING_STEPS = 12;
const int MEETING_SECANTS = 8;

// Clip coordinates, w > 0 -> pixels.
vec2 pixelOf(vec4 clip) { return (vec2(0.5, -0.5) * clip.xy / clip.w + 0.5) * frame.picture.xy; }

float depthBehind(vec2 at) {
    return texelFetch(backdropDepth, ivec2(clamp(at, vec2(0.0), frame.picture.xy - 1.0)), 0).x;
}

// How far along the ray from `from` (clip coordinates; `along` per metre) the depth is z: negative if never.
float distanceToDepth(vec4 from, vec4 along, float z) {
    float rate = along.z - z * along.w;
    return rate == 0.0 ? -1.0 : (z * from.w - from.z) / rate;
}

// Metres until the ray has left the box of the scene: there is nothing to meet behind.
float distanceOutOfScene(vec3 origin, vec3 direction) {
    vec3 inverse = 1.0 / direction; // infinite along an axis that it does not move on, which min and max take
    vec3 far = max((frame.boundsLow.xyz - origin) * inverse, (frame.boundsHigh.xyz - origin) * inverse);
    return min(far.x, min(far.y, far.z));
}

Meeting nowhere() {
    Meeting m;
    m.distance = -1.0;
    m.seen = false;
    m.foreshortening = 1.0;
    return m;
}

Meeting meetByGuess(vec4 from, vec4 along, out bool settled) {
    Meeting meeting = nowhere();
    meeting.distance = 0.0;
    meeting.seen = true;
    settled = false;
    vec2 at = pixelOf(from);
    for (int k = 0; k < MEETING_GUESSES; ++k) {
        float z = depthBehind(at);
        bool sky = z == 0.0;
        float distance = sky ? -1.0 : distanceToDepth(from, along, z);
        vec4 there = sky ? along : from + distance * along;
        if ((!sky && !(distance >= 0.0)) || !(there.w > 0.0)) return meeting;
        // Off the picture its border goes on (depthBehind): the picture's share in the beam fades there, it does not end.
        vec2 next = pixelOf(there);
        vec2 moved = abs(next - at);
        at = next;
        meeting.distance = distance;
        // Within a pixel the depth that was read is the depth there.
        settled = k > 0 && max(moved.x, moved.y) < 1.0;
        if (settled) return meeting;
    }
    return meeting;
}

// In front of the surface: positive.
float heightAbove(vec3 ndc) {
    float z = depthBehind((vec2(0.5, -0.5) * ndc.xy + 0.5) * frame.picture.xy);
    return ndc.z - z;
}

// Even steps on the screen are even in 1 / w: the share of the way at a share v of the picture's.
float wayAlong(float v, float wFrom, float wTo) {
    float near = (1.0 - v) / wFrom;
    float far = v / wTo;
    return far / (near + far);
}

vec3 placeOf(vec2 at, float z) {
    vec2 clip = 2.0 * at / frame.picture.xy - 1.0;
    vec4 p = frame.worldFromClip * vec4(clip.x, -clip.y, z, 1.0);
    return p.xyz / p.w;
}

// The surface at a pixel, seen along the view and along the beam: the ratio of the two cosines. Of the two neighbours along each
// axis the one that is less far in depth belongs to the same surface.
float foreshorteningAt(vec2 at, vec3 direction) {
    vec2 centre = floor(clamp(at, vec2(1.0), frame.picture.xy - 2.0)) + 0.5;
    float z = depthBehind(centre);
    float right = depthBehind(centre + vec2(1.0, 0.0));
    float left = depthBehind(centre - vec2(1.0, 0.0));
    float down = depthBehind(centre + vec2(0.0, 1.0));
    float up = depthBehind(centre - vec2(0.0, 1.0));
    vec3 p = placeOf(centre, z);
    bool toRight = abs(right - z) < abs(left - z);
    bool toDown = abs(down - z) < abs(up - z);
    vec3 x = placeOf(centre + vec2(toRight ? 1.0 : -1.0, 0.0), toRight ? right : left) - p;
    vec3 y = placeOf(centre + vec2(0.0, toDown ? 1.0 : -1.0), toDown ? down : up) - p;
    vec3 n = cross(x, y);
    vec3 view = frame.eye.w > 0.0 ? normalize(p - frame.eye.xyz) : frame.viewDirection.xyz;
    // At a grazing beam the spot on the surface grows without end; past a factor of 16 it is the sky's business.
    float seen = abs(dot(n, view));
    float met = abs(dot(n, direction));
    return clamp(seen / max(met, 1e-30), 1.0 / 16.0, 16.0);
}

Meeting meetBySteps(vec4 from, vec4 along, float most) {
    Meeting miss = nowhere();
    float hidden = -1.0; // where it went behind something
    // The way to the end, as far as it stays on the picture and before the camera: each clip plane x = ±w, y = ±w and
    // w = (a hundredth of) where it began cuts off what lies beyond.
    vec4 way = most * along;
    float end = 1.0;
    vec4 room = vec4(from.w - from.x, from.w + from.x, from.w - from.y, from.w + from.y);
    vec4 loss = vec4(way.x - way.w, -way.x - way.w, way.y - way.w, -way.y - way.w);
    for (int k = 0; k < 4; ++k)
        if (loss[k] > room[k]) end = min(end, max(room[k], 0.0) / loss[k]);
    if (-way.w > 0.99 * from.w) end = min(end, 0.99 * from.w / -way.w);
    vec4 to = from + end * way;
    miss.seen = end == 1.0 && along.w > 0.0 && depthBehind(pixelOf(along)) == 0.0;
    vec3 a = from.xyz / from.w;
    vec3 b = to.xyz / to.w;
    float before = 0.0;
    float heightBefore = heightAbove(a);
    for (int k = 1; k <= MEETING_STEPS; ++k) {
        float u = float(k) / float(MEETING_STEPS);
        float height = heightAbove(mix(a, b, u));
        if (heightBefore >= 0.0 && height < 0.0) {
            float low = before;
            float heightLow = heightBefore;
            float high = u;
            float heightHigh = height;
            for (int j = 0; j < MEETING_SECANTS; ++j) {
                // In the middle first: a step in depth between the two ends, like the outline of what the ray leaves, would hold a
                // secant at one of them.
                float cut = (j & 1) == 1 ? heightLow / (heightLow - heightHigh) : 0.5;
                float middle = mix(low, high, cut);
                float heightMiddle = heightAbove(mix(a, b, middle));
                bool front = heightMiddle >= 0.0;
                low = front ? middle : low;
                heightLow = front ? heightMiddle : heightLow;
                high = front ? high : middle;
                heightHigh = front ? heightHigh : heightMiddle;
                // Within a fiftieth of where it began the rest is less than a step on the way divided by fifty.
                if (min(heightLow, -heightHigh) < 0.02 * (heightBefore - height)) break;
            }
            // Over a surface the heights close in on 0, at an edge they do not: there the ray went behind something nearer, and
            // comes out again or not.
            if (min(heightLow, -heightHigh) < 0.1 * (heightBefore - height)) {
                float v = mix(low, high, heightLow / max(heightLow - heightHigh, 1e-30));
                miss.distance = most * end * wayAlong(v, from.w, to.w);
                miss.seen = true;
                return miss;
            }
            hidden = low;
        }
        before = u;
        heightBefore = height;
    }
    // It ends behind something: what is seen beside that is the best guess, and continuous with what is seen before.
    if (hidden >= 0.0 && heightBefore < 0.0) {
        miss.distance = most * end * wayAlong(hidden, from.w, to.w);
        miss.seen = true;
        return miss;
    }
    // Out at the picture's edge, in front of what is there: the border goes on.
    if (end < 1.0 && heightBefore >= 0.0) {
        float z = b.z - heightBefore;
        miss.distance = z > 0.0 ? distanceToDepth(from, along, z) : -1.0;
        miss.seen = z > 0.0 ? miss.distance >= 0.0 : along.w > 0.0;
    }
    return miss;
}

// `guess`: depth to depth first; not where the ray starts from a surface that is in the depth.
Meeting meetBackdrop(vec3 origin, vec3 direction, bool guess) {
    Meeting meeting = nowhere();
    vec4 from = frame.clipFromWorld * vec4(origin, 1.0);
    vec4 along = frame.clipFromWorld * vec4(direction, 0.0);
    if (!(from.w > 0.0)) return meeting;
    bool settled = false;
    if (guess) meeting = meetByGuess(from, along, settled);
    // A wall may be what bounds the scene: a fiftieth further.
    if (!settled) meeting = meetBySteps(from, along, 1.02 * max(distanceOutOfScene(origin, direction), 0.0));
    if (meeting.seen && meeting.distance > 0.0)
        meeting.foreshortening = foreshorteningAt(pixelOf(from + meeting.distance * along), direction);
    return meeting;
}

vec3 farRadiance(vec3 direction, float sigma) {
    if (!hasEnvironment) return vec3(0.0);
    return frame.environment.z * environmentRadiance(stackEven, stackOdd, frame.stack, inEnvironment(direction), sigma);
}

// Radiance that arrives along the beam. `meeting`: of its centre, or of another beam of nearly the same origin and direction.
vec3 beamRadiance(Beam beam, Meeting meeting) {
    float share = 0.0;
    vec3 near = vec3(0.0);
    bool ends = meeting.distance >= 0.0;
    vec4 place = ends ? vec4(beam.origin + meeting.distance * beam.direction, 1.0) : vec4(beam.direction, 0.0);
    vec4 clip = frame.clipFromWorld * place;
    if (meeting.seen && clip.w > 0.0) {
        vec3 fromEye = ends ? place.xyz - frame.eye.xyz : beam.direction;
        float range = length(fromEye);
        float pixels; // sigma
        if (frame.eye.w > 0.0) {
            float angle = ends ? sqrt(beamVariance(beam.sigma, beam.carried, beam.inner, beam.inside, meeting.distance)) / range
                               : beam.sigma;
            pixels = angle * pixelsPerRadian(frame.picture.z, min(clip.w / range, 1.0));
        } else {
            // An orthographic camera sees one direction of the sky only: the rest is the environment's business.
            pixels = ends ? sqrt(beamVariance(beam.sigma, beam.carried, beam.inner, beam.inside, meeting.distance)) * frame.picture.z
                          : 0.0;
        }
        pixels *= sqrt(meeting.foreshortening);
        vec2 at = pixelOf(clip);
        // Off the picture the sky is known better from the environment. A surface is not: its border stands for it, ever more
        // blurred, and fades as the picture's size tells how far a guess may reach.
        vec2 outside = max(max(-at, at - frame.picture.xy), vec2(0.0)) / (OUTSIDE_FADE * frame.picture.y);
        share = ends ? exp(-0.5 * dot(outside, outside)) : pyramidCoverage(at, frame.picture.xy, pixels);
        outside *= OUTSIDE_FADE * frame.picture.y;
        if (share > 0.0) {
            float variance = pixels * pixels + dot(outside, outside);
            vec4 seen = fetchPyramid(screenPyramid, at, frame.picture.xy, variance, frame.picture.w);
            // Where less than half of the blur falls on what can be behind, the environment comes in for the rest.
            share *= min(2.0 * seen.w, 1.0);
            near = seen.w > 0.0 ? seen.xyz / seen.w : vec3(0.0);
        }
    }
    if (share >= 0.999) return near; // what is left, a thousandth, is below what 8 bits show
    return mix(farRadiance(beam.direction, beam.sigma), near, share);
}
