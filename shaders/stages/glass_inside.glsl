// glass_inside.glsl: the way of light inside a solid, to the face that it leaves by.
// Frame    world, metres; directions unit.
// Needs    stages/glass_faces.glsl, stages/object.glsl, interface/instance.glsl.
// Source   refraction/exit_search.glsl.
// Energy   what a face throws back is followed to the next where most of the light is, beyond the critical angle; else it is left over.
//          A spread of rays changes what passes. What facets hide of what they scatter, single scattering loses: the face's own.
#include "refraction/exit_search_fetch.glsl"
#include "refraction/wandering.glsl"
#include "stages/picture_pixel.glsl"

layout(binding = 26) uniform usampler2DArray interior; // stages/interior.frag

layout(constant_id = 42) const int mostBounces = 2; // total reflections that are followed

// Light that has lost its way in a body that is not convex leaves it on all sides alike: after two reflections inside, paths through
// the material ball have a mean direction of .1. Smooth walls, between which few ways are open, keep it going forwards.
const bool losesItsWay = interiorPairs > 1 && !isSmooth;
// There a search beyond the first reflection finds where one ray in two goes (tests/interior), of a beam that is wide by then.
const int followed = losesItsWay && mostBounces > 1 ? 1 : mostBounces;
// Of what gets out of such a body about half meets it again (paths through the material ball and Suzanne).
const float MEETS_AGAIN = 0.5;
// Where it goes forwards it comes from a cone of about a radian.
const float LEFT_OVER_SIGMA = 0.5; // radians
// Of what a diffuse face sends, the mean square of the angle is pi²/8 - 1/2, half of that per axis: nothing leaves a face wider.
const float HEMISPHERE_SIGMA = 0.606;

InteriorView interiorCamera() { return interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy); }

// What has been thrown back is so wide that the face turns by a radian over its spot: it is not bundled as by one curvature. The
// turn counts by the mean of the cosine of what the normals differ by.
vec2 seenBySpread(vec2 turn, float sigma) {
    vec2 differ = turn * sigma;
    return turn * exp(-0.5 * differ * differ);
}

// A facet's tilt turns a reflected ray by 2 cos of it, a curved face spreads what is already spread. Tables give a Gaussian of
// 1 / shape times the slope's width (composition_view.glsl, Widening).
float reflectedSpread(float sigma, ExitSurface s, float cosTheta, float shape) {
    float curved = abs(1.0 - 2.0 * s.turn.x) * abs(1.0 - 2.0 * s.turn.y * cosTheta);
    float facets = 2.0 * cosTheta * s.alpha / shape;
    return min(sqrt(sigma * sigma * curved + facets * facets), 1.0);
}

// Length of a unit of the mesh's, metres.
float meshUnit() {
    return (length(instance.worldFromMesh[0].xyz) + length(instance.worldFromMesh[1].xyz) +
            length(instance.worldFromMesh[2].xyz)) / 3.0;
}

WanderingLoss wanderingLoss() { return distribution == 0 ? wanderingLossGgx() : wanderingLossBeckmann(); }

// Light inside where it comes to a face.
struct InnerArrival {
    InnerTap ray;
    ExitSurface face;
    vec3 point;
    float run;     // metres since it came in
    float segment; // of these, since the face before
};

// What the face makes of it.
struct FaceSplit {
    float passes;     // share of the light
    float kept;       // with what is reflected; single scattering loses the rest
    float reflected;  // energy
    vec3 direction;   // of that
    float sigma;
};

FaceSplit splitAt(InnerArrival a, float invIor, Widening k) {
    ExitView seen = seeExit(a.ray, true, a.face, k);
    float cosTheta = max(seen.cosTheta, 0.0);
    FaceSplit split;
    split.kept = keptByFace(faceEnergy(cosTheta, a.face.alpha, invIor));
    split.passes = min(faceEnergy(cosTheta, seen.alphaEnergy, invIor).transmitted, split.kept);
    split.reflected = a.ray.weight * (split.kept - split.passes);
    split.direction = reflect(a.ray.direction, a.face.n);
    split.sigma = reflectedSpread(a.ray.sigma, a.face, seen.cosTheta, k.shape);
    return split;
}

// Where the light that entered first comes to a face. Of a mesh that has no far side, a plate whose thickness is given, that is
// the other face.
InnerArrival firstArrival(Surface s, InnerTap core, float entered, float invIor) {
    InnerArrival a;
    a.ray = core;
    a.ray.weight = entered;
    float across = surfaceThickness() * meshUnit();
    a.run = across / max(-dot(core.direction, s.n), 0.05); // a ray along the plate leaves it after 20 thicknesses
    a.point = s.position + a.run * core.direction;
    a.face.n = -s.n;
    a.face.alpha = s.alpha;
    a.face.eta = invIor;
    a.face.turn = vec2(0.0);
    if (interiorPairs > 0) {
        InteriorView view = interiorCamera();
        float guess = interiorThickness(interior, view, picturePixel(), objectId());
        ExitHit hit = findExit(interior, view, interiorPairs, objectId(), s.position, core.direction, guess, false);
        if (hit.found > 0.0) {
            a.run = hit.distance;
            a.face.n = hit.n;
            a.face.alpha = hit.alpha;
            a.face.turn = exitTurn(dot(core.direction, hit.n), a.run, hit.curvature);
            a.point = hit.point;
        }
    }
    a.segment = a.run;
    return a;
}

// Followed where most of the light is: beyond the critical angle, and as long as a way can be told.
bool goesOn(InnerArrival a, FaceSplit split) {
    bool most = split.reflected >= 0.5 * a.ray.weight;
    return most && (interiorPairs > 1 || split.sigma <= LEFT_OVER_SIGMA);
}

// To the face after: a.segment is negative where there is none. `across`: metres through the wall at s, for walls thinner than the
// search resolves, whose next face is the one that the light came in by.
InnerArrival nextArrival(Surface s, InnerArrival a, FaceSplit split, float across) {
    InnerArrival next = a;
    next.ray.direction = split.direction;
    next.ray.sigma = split.sigma;
    next.ray.weight = split.reflected;
    InteriorView view = interiorCamera();
    float guess = interiorThickness(interior, view, picturePixel(), objectId());
    ExitHit hit = findExit(interior, view, interiorPairs, objectId(), a.point, split.direction, guess, true);
    if (hit.found > 0.0) {
        next.segment = hit.distance;
        next.face.n = hit.n;
        next.face.alpha = hit.alpha;
        next.face.turn = seenBySpread(exitTurn(dot(split.direction, hit.n), a.run + hit.distance, hit.curvature), split.sigma);
        next.point = hit.point;
    } else {
        float back = dot(split.direction, s.n);
        next.segment = back > 0.0 ? across / back : -1.0;
        next.face.n = s.n;
        next.face.alpha = s.alpha;
        next.face.turn = vec2(0.0);
        next.point = a.point + next.segment * split.direction;
    }
    next.run = a.run + next.segment;
    return next;
}

// How the light inside comes to the face that it leaves by.
struct InnerPath {
    InnerArrival first;
    InnerArrival last;   // after total reflections; the first again if there was none
    bool bounced;
    float passedBetween; // energy that passed the faces beyond which the light was followed
};

// On from the first face, by total reflections.
InnerPath followReflections(Surface s, InnerArrival first, float invIor, Widening k) {
    InnerPath p;
    p.first = first;
    p.last = first;
    p.bounced = false;
    p.passedBetween = 0.0;
    if (interiorPairs == 0) return p;
    float across = first.run * max(-dot(first.ray.direction, s.n), 0.0);
    for (int bounce = 0; bounce < followed; ++bounce) {
        FaceSplit split = splitAt(p.last, invIor, k);
        if (!goesOn(p.last, split)) break;
        InnerArrival next = nextArrival(s, p.last, split, across);
        if (next.segment < 0.0) break;
        if (losesItsWay && bounce > 0) p.passedBetween += p.last.ray.weight * split.passes;
        p.last = next;
        p.bounced = true;
    }
    return p;
}

// What is reflected at the last face that was found.
struct Residual {
    vec3 point;     // where it is looked for, outside
    vec3 direction;
    float sigma;
    float energy;
    Wandering leaves; // what becomes of it at each face that it comes to
};

Residual residualOf(Surface s, InnerPath p, float invIor, Widening k) {
    FaceSplit split = splitAt(p.last, invIor, k);
    // Beyond the critical angle and in bodies that are not convex it wanders: of all guesses, what is behind a convex body is
    // nearest to brute force.
    Residual r;
    r.energy = split.reflected;
    r.leaves = wanderingAt(p.last.face.alpha, 1.0 / invIor, wanderingLoss());
    if (losesItsWay) r.leaves = wanderingConcave(r.leaves, MEETS_AGAIN);
    r.point = p.last.point;
    r.direction = -s.wo;
    r.sigma = max(split.sigma, LEFT_OVER_SIGMA);
    if (interiorPairs > 1 || (split.reflected >= 0.5 * p.last.ray.weight && split.sigma <= LEFT_OVER_SIGMA)) return r;
    // Else what a convex body throws back leaves by its near face: of a plate that is the one that is seen, of a curved body the
    // one that the sphere with the same chord has there.
    bool isFlat = p.last.face.turn == vec2(0.0);
    vec3 n = p.last.face.n;
    vec3 near = isFlat ? s.n : normalize(n + 2.0 * dot(p.last.ray.direction, n) * split.direction);
    vec3 outward = refractAbout(-split.direction, -near, invIor);
    // Of what is too wide for a hemisphere so much is pushed from the face towards its normal.
    float wide = split.sigma / invIor; // small angles grow by the index there
    float folded = max(1.0 - HEMISPHERE_SIGMA / max(wide, HEMISPHERE_SIGMA), 0.0);
    bool refracted = dot(outward, near) > 0.0;
    if (!refracted && split.sigma <= LEFT_OVER_SIGMA) return r;
    // Again and again, each time with the same shares. A smooth face loses nothing: below a hundredth it is the table's rounding.
    r.leaves.passes = split.passes;
    r.leaves.back = min(split.kept + 0.01, 1.0) - split.passes;
    vec3 along = split.direction - dot(split.direction, near) * near;
    if (!refracted) outward = dot(along, along) > 0.0 ? normalize(along) : near;
    r.point = p.last.point + p.last.segment * split.direction; // chords of one length
    r.direction = normalize(mix(outward, near, folded * (1.0 - dot(outward, near))));
    r.sigma = min(wide, HEMISPHERE_SIGMA);
    return r;
}
