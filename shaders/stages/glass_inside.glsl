// glass_inside.glsl: the way of light inside a solid, to the face that it leaves by.
// Frame    world, metres; directions unit.
// Needs    stages/glass_faces.glsl, stages/object.glsl, interface/instance.glsl.
// Source   refraction/exit_search.glsl.
// Energy   internally reflected light is followed to the next face beyond the critical angle, where it is most of the light; else
//          it is residual. The share that passes is that of the whole spread of rays. Masked light is lost (single scattering).
#include "refraction/exit_search_fetch.glsl"
#include "refraction/internal_scattering.glsl"
#include "stages/picture_pixel.glsl"

layout(binding = 26) uniform usampler2DArray interior; // stages/interior.frag

layout(constant_id = 52) const int mostBounces = 2; // total reflections that are followed

// In a body that is not convex, diffuse internal scattering leaves on all sides alike: after two internal reflections, paths
// through the material ball have a mean direction of length .1. Between smooth walls light keeps its direction.
const bool losesItsWay = interiorPairs > 1 && !isSmooth;
// There a search beyond the first reflection is right for one ray in two (tests/interior), and the lobe is wide by then.
const int followed = losesItsWay && mostBounces > 1 ? 1 : mostBounces;
// Of what gets out of such a body about half meets it again (paths through the material ball and Suzanne).
const float MEETS_AGAIN = 0.5;
// Where light keeps its direction: a cone of about a radian.
const float RESIDUAL_SIGMA = 0.5; // radians
// The widest lobe that leaves a face is a cosine lobe: mean square of its angle pi²/8 - 1/2, half of that per axis.
const float HEMISPHERE_SIGMA = 0.606;

InteriorView interiorCamera() { return interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy); }

// An internally reflected lobe is so wide that the normal turns by a radian over its footprint: one curvature does not focus it.
// The turn counts by the mean cosine between the normals.
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

InternalScatteringLoss internalScatteringLoss() { return distribution == 0 ? internalScatteringLossGgx() : internalScatteringLossBeckmann(); }

// Light inside where it comes to a face.
struct InnerArrival {
    InnerLobe ray;
    ExitSurface face;
    vec3 point;
    float run;     // metres since it came in
    float segment; // of these, since the face before
};

// Its energy and direction after the face.
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

// Where `ray` next comes to a face: first of all from s, or `reflected`, then from the place of `before`. segment is negative where
// there is none.
InnerArrival reachFace(Surface s, InnerArrival before, InnerLobe ray, float invIor, bool reflected) {
    InnerArrival a = before;
    a.ray = ray;
    a.face.eta = invIor;
    a.face.turn = vec2(0.0);
    vec3 from = s.position;
    float cosTheta = -dot(ray.direction, s.n);
    // For an open sheet with a given thickness it is the other face of the plate; a grazing ray leaves after 20 thicknesses.
    a.segment = surfaceThickness() * meshUnit() / max(cosTheta, 0.05);
    a.face.n = -s.level;
    a.face.alpha = s.alpha;
    if (reflected) {
        // A wall thinner than the search resolves: the entry face.
        from = before.point;
        a.segment = cosTheta < 0.0 ? before.segment * dot(before.ray.direction, s.n) / cosTheta : -1.0;
        a.face.n = s.level;
    }
    if (interiorPairs > 0) {
        InteriorView view = interiorCamera();
        float guess = interiorThickness(interior, view, picturePixel(), objectId());
        ExitHit hit = findExit(interior, view, interiorPairs, objectId(), from, ray.direction, guess, reflected);
        if (hit.found > 0.0) {
            a.segment = hit.distance;
            a.face.n = hit.n;
            a.face.alpha = hit.alpha;
            a.face.turn = exitTurn(dot(ray.direction, hit.n), before.run + hit.distance, hit.curvature);
            if (reflected) a.face.turn = seenBySpread(a.face.turn, ray.sigma);
        }
    }
    if (leansByBrush) {
        vec2 widths = vec2(s.along, s.across);
        if (ofPixel(material.transmission.y) >= 0.0) widths = ggxAnisoWidths(material.transmission.y, material.anisotropy.x);
        BrushedFacets f = facetsOfFarFace(a.face.n, ray.direction, s.brush, widths, invIor);
        a.face.n = f.n;
        a.face.alpha = f.alpha;
        a.ray.weight *= f.weight;
    }
    a.point = from + a.segment * ray.direction;
    a.run = before.run + a.segment;
    return a;
}

// The light at s, which has entered.
InnerArrival entering(Surface s, InnerLobe core, float entered) {
    InnerArrival a;
    a.ray = core;
    a.ray.weight = entered;
    a.face.n = s.n;
    a.face.alpha = s.alpha;
    a.face.eta = 1.0;
    a.face.turn = vec2(0.0);
    a.point = s.position;
    a.run = 0.0;
    a.segment = 0.0;
    return a;
}

InnerArrival firstArrival(Surface s, InnerLobe core, float entered, float invIor) {
    InnerArrival from = entering(s, core, entered);
    return reachFace(s, from, from.ray, invIor, false);
}

// Followed beyond the critical angle, where most of the light is, and as long as the search finds the next face.
bool goesOn(InnerArrival a, FaceSplit split) {
    bool most = split.reflected >= 0.5 * a.ray.weight;
    return most && (interiorPairs > 1 || split.sigma <= RESIDUAL_SIGMA);
}

InnerLobe reflectedRay(FaceSplit split) {
    InnerLobe ray;
    ray.direction = split.direction;
    ray.sigma = split.sigma;
    ray.weight = split.reflected;
    return ray;
}

// How the light inside comes to the face that it leaves by.
struct InnerPath {
    InnerArrival first;
    InnerArrival last;   // after total reflections; the first again if there was none
    bool reflectedInside;
    float passedBetween; // energy that passed the faces beyond which the light was followed
};

// From `before` on; where that is the light at s itself, `hasFirst` is false. The search is written once: devices that
// run pixels in lockstep pay for every copy.
InnerPath followFaces(Surface s, InnerArrival before, bool hasFirst, float invIor, Widening k) {
    InnerPath p;
    p.first = before;
    p.last = before;
    p.reflectedInside = false;
    p.passedBetween = 0.0;
    for (int bounce = hasFirst ? 1 : 0; bounce <= followed; ++bounce) {
        InnerLobe ray = p.last.ray;
        float passed = 0.0;
        if (bounce > 0) {
            FaceSplit split = splitAt(p.last, invIor, k);
            if (interiorPairs == 0 || !goesOn(p.last, split)) break;
            ray = reflectedRay(split);
            passed = p.last.ray.weight * split.passes;
        }
        InnerArrival next = reachFace(s, p.last, ray, invIor, bounce > 0);
        if (next.segment < 0.0) break;
        if (losesItsWay && bounce > 1) p.passedBetween += passed;
        p.last = next;
        if (bounce == 0) p.first = next;
        p.reflectedInside = bounce > 0;
    }
    return p;
}

// What is reflected at the last face that was found.
struct Residual {
    vec3 point;     // origin of its lookup, outside
    vec3 direction;
    float sigma;
    float energy;
    InternalScattering leaves; // what becomes of it at each face that it comes to
};

Residual residualOf(Surface s, InnerPath p, float invIor, Widening k) {
    FaceSplit split = splitAt(p.last, invIor, k);
    // Beyond the critical angle and in bodies that are not convex it scatters diffusely. Looking it up behind a convex body was
    // nearest to the path tracer of all that was tried.
    Residual r;
    r.energy = split.reflected;
    r.leaves = internalScatteringAt(p.last.face.alpha, 1.0 / invIor, internalScatteringLoss());
    if (losesItsWay) r.leaves = internalScatteringConcave(r.leaves, MEETS_AGAIN);
    r.point = p.last.point;
    r.direction = -s.wo;
    r.sigma = max(split.sigma, RESIDUAL_SIGMA);
    if (interiorPairs > 1 || (split.reflected >= 0.5 * p.last.ray.weight && split.sigma <= RESIDUAL_SIGMA)) return r;
    // Else light that a convex body reflects inside leaves by its near face: the visible face of a plate; on a curved body the face
    // of the sphere with the same chord.
    bool isFlat = p.last.face.turn == vec2(0.0);
    vec3 n = p.last.face.n;
    vec3 near = isFlat ? s.n : normalize(n + 2.0 * dot(p.last.ray.direction, n) * split.direction);
    vec3 outward = refractAbout(-split.direction, -near, invIor);
    // A lobe too wide for the hemisphere is turned towards the normal by this much.
    float wide = split.sigma / invIor; // small angles grow by the IOR there
    float folded = max(1.0 - HEMISPHERE_SIGMA / max(wide, HEMISPHERE_SIGMA), 0.0);
    bool refracted = dot(outward, near) > 0.0;
    if (!refracted && split.sigma <= RESIDUAL_SIGMA) return r;
    // A geometric series with the same shares at each face. A smooth face loses nothing: below a hundredth it is the table's
    // rounding.
    r.leaves.passes = split.passes;
    r.leaves.back = min(split.kept + 0.01, 1.0) - split.passes;
    vec3 along = split.direction - dot(split.direction, near) * near;
    if (!refracted) outward = dot(along, along) > 0.0 ? normalize(along) : near;
    r.point = p.last.point + p.last.segment * split.direction; // chords of one length
    r.direction = normalize(mix(outward, near, folded * (1.0 - dot(outward, near))));
    r.sigma = min(wide, HEMISPHERE_SIGMA);
    return r;
}
