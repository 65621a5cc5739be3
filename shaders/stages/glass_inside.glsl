// glass_inside.glsl: the way of light inside a solid, to the face that it leaves by.
// Frame    world, metres; directions unit.
// Needs    stages/glass_faces.glsl, stages/object.glsl, interface/instance.glsl.
// Source   refraction/exit_search.glsl.
// Energy   what a face throws back is followed to the next where most of the light is, beyond the critical angle; else it is left over.
//          A spread of rays changes what passes. What facets hide of what they scatter, single scattering loses: the face's own.
#include "refraction/exit_search_fetch.glsl"
#include "refraction/wandering.glsl"

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

// How the light inside comes to the face that it leaves by.
struct InnerPath {
    ExitSurface first;   // where the ray first comes to a face
    vec3 point;
    float path;          // metres
    ExitSurface last;    // after total reflections; the first again if there was none
    InnerTap ray;        // that comes there
    vec3 lastPoint;
    float lastPath;
    bool bounced;
    vec3 leftPoint;      // where what is thrown back there is looked for, outside
    vec3 leftDirection;
    float leftSigma;
    float left;          // its energy
    Wandering leaves;    // what becomes of that at each face that it comes to
    float passedBetween; // energy that passed the faces beyond which the light was followed
};

InnerPath followInside(Surface s, InnerTap core, float entered, float invIor, Widening k) {
    InnerPath p;
    // A plate: the other face of a mesh that has no far side, whose thickness is given.
    float across = surfaceThickness() * meshUnit();
    p.path = across / max(-dot(core.direction, s.n), 0.05); // a ray along the plate leaves it after 20 thicknesses
    p.point = s.position + p.path * core.direction;
    p.first.n = -s.n;
    p.first.alpha = s.alpha;
    p.first.eta = invIor;
    p.first.turn = vec2(0.0);
    p.ray = core;
    p.ray.weight = entered;
    p.bounced = false;
    p.last = p.first;
    p.lastPoint = p.point;
    p.lastPath = p.path;
    p.passedBetween = 0.0;

    InteriorView view = interiorCamera();
    float guess = interiorPairs > 0 ? interiorThickness(interior, view, ivec2(gl_FragCoord.xy), objectId()) : 0.0;
    vec3 from = s.position;
    float run = 0.0;
    for (int bounce = 0; bounce <= followed; ++bounce) {
        if (interiorPairs > 0) {
            ExitHit hit = findExit(interior, view, interiorPairs, objectId(), from, p.ray.direction, guess, bounce > 0);
            if (hit.found > 0.0) {
                run += hit.distance;
                p.last.n = hit.n;
                p.last.alpha = hit.alpha;
                p.last.turn = exitTurn(dot(p.ray.direction, hit.n), run, hit.curvature);
                if (bounce > 0) p.last.turn = seenBySpread(p.last.turn, p.ray.sigma);
                p.lastPoint = hit.point;
                p.lastPath = run;
                if (bounce == 0) {
                    p.first = p.last;
                    p.point = p.lastPoint;
                    p.path = run;
                }
                p.bounced = bounce > 0;
            } else if (bounce > 0) {
                // Of a wall thinner than the search resolves it is the face that the light came in by.
                float back = dot(p.ray.direction, s.n);
                if (!(back > 0.0)) break;
                float across = p.path * max(-dot(core.direction, s.n), 0.0) / back;
                run += across;
                p.last.n = s.n;
                p.last.alpha = s.alpha;
                p.last.turn = vec2(0.0);
                p.lastPoint = from + across * p.ray.direction;
                p.lastPath = run;
                p.bounced = true;
            }
        }
        ExitView seen = seeExit(p.ray, true, p.last, k);
        float cosTheta = max(seen.cosTheta, 0.0);
        float kept = keptByFace(faceEnergy(cosTheta, p.last.alpha, invIor));
        float passes = min(faceEnergy(cosTheta, seen.alphaEnergy, invIor).transmitted, kept);
        float thrownBack = p.ray.weight * (kept - passes);
        float spread = reflectedSpread(p.ray.sigma, p.last, seen.cosTheta, k.shape);
        vec3 reflected = reflect(p.ray.direction, p.last.n);
        // Beyond the critical angle and in bodies that are not convex it wanders: of all guesses, what is behind a convex body is
        // nearest to brute force.
        p.left = thrownBack;
        p.leaves = wanderingAt(p.last.alpha, 1.0 / invIor, wanderingLoss());
        if (losesItsWay) p.leaves = wanderingConcave(p.leaves, MEETS_AGAIN);
        p.leftPoint = p.lastPoint;
        p.leftDirection = -s.wo;
        p.leftSigma = max(spread, LEFT_OVER_SIGMA);
        bool isFlat = p.last.turn == vec2(0.0);
        if (interiorPairs < 2 && (thrownBack < 0.5 * p.ray.weight || spread > LEFT_OVER_SIGMA)) {
            // Else what a convex body throws back leaves by its near face: of a plate that is the one that is seen, of a curved body the
            // one that the sphere with the same chord has there.
            vec3 near = isFlat ? s.n : normalize(p.last.n + 2.0 * dot(p.ray.direction, p.last.n) * reflected);
            vec3 outward = refractAbout(-reflected, -near, invIor);
            // Of what is too wide for a hemisphere so much is pushed from the face towards its normal.
            float wide = spread / invIor; // small angles grow by the index there
            float folded = max(1.0 - HEMISPHERE_SIGMA / max(wide, HEMISPHERE_SIGMA), 0.0);
            bool refracted = dot(outward, near) > 0.0;
            if (refracted || spread > LEFT_OVER_SIGMA) {
                // Again and again, each time with the same shares. A smooth face loses nothing: below a hundredth it is the
                // table's rounding.
                p.leaves.passes = passes;
                p.leaves.back = min(kept + 0.01, 1.0) - passes;
                vec3 along = reflected - dot(reflected, near) * near;
                if (!refracted) outward = dot(along, along) > 0.0 ? normalize(along) : near;
                p.leftPoint = p.lastPoint + distance(p.lastPoint, from) * reflected; // chords of one length
                p.leftDirection = normalize(mix(outward, near, folded * (1.0 - dot(outward, near))));
                p.leftSigma = min(wide, HEMISPHERE_SIGMA);
            }
        }
        // Followed where most of the light is: beyond the critical angle.
        if (interiorPairs == 0 || bounce == followed || thrownBack < 0.5 * p.ray.weight) break;
        if (interiorPairs == 1 && spread > LEFT_OVER_SIGMA) break; // and no way can be told any more
        if (losesItsWay && bounce > 0) p.passedBetween += p.ray.weight * passes;
        p.ray.sigma = spread;
        p.ray.direction = reflected;
        p.ray.weight = thrownBack;
        from = p.lastPoint;
    }
    return p;
}
