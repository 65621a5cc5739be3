// glass.glsl: the light that comes through a surface of glass, as beams that leave it.
// Frame    world, metres; directions unit. eta = n_far / n_near of the face in question.
// Needs    stages/surface.glsl, stages/surroundings.glsl, interface/material.glsl, stages/object.glsl.
// Source   DESIGN.md §2 (1)-(5); refraction/composition.glsl; refraction/exit_search.glsl.
// Energy   what the first face lets in either leaves where the ray first comes to a face, or is thrown back there and is followed
//          to the next, or is left over, which takes one wide lookup.
// Form     every lookup is made in one place (glassRadiance): machines that run pixels in lockstep pay for all that is
//          written, taken or not.
#include "bsdf/transmission.glsl"
#include "refraction/composition_fetch.glsl"
#include "refraction/exit_search_fetch.glsl"

layout(binding = 22) uniform sampler3D interfaceEnergyTable;
layout(binding = 23) uniform sampler3D interfaceLobeTable;
layout(binding = 26) uniform usampler2DArray interior; // stages/interior.frag

layout(constant_id = 42) const int mostBounces = 2; // total reflections that are followed

// Light that has lost its way comes from a cone of about a radian.
const float LEFT_OVER_SIGMA = 0.5; // radians
// Of what a diffuse face sends, the mean square of the angle is pi²/8 - 1/2, half of that per axis: nothing leaves a face wider.
const float HEMISPHERE_SIGMA = 0.606;

struct WeightedBeam {
    Beam beam;
    vec3 weight; // 0: it is not there
};

// What one pixel of glass sends, besides its reflection. The first two leave at one place and meet the same thing.
struct GlassBeams {
    WeightedBeam core;
    WeightedBeam rest;
    WeightedBeam bounced;  // leaves after total reflection
    WeightedBeam leftOver;
    ExitSurface leaving; // where the first two leave, by which ray from within
    vec3 inner;
    float within; // metres to something opaque inside that ends the core; negative: none
};

// The glass's own reflection.
struct MirrorBeams {
    WeightedBeam core;
    WeightedBeam rest; // not there where the lobe's table has one tap
};

// KHR_materials_dispersion: red and blue to both sides of the index, by a fortieth of (ior - 1) times the dispersion each.
float dispersedIor(float ior, float dispersion, int channel) {
    return max(ior + (float(channel) - 1.0) * 0.025 * (ior - 1.0) * dispersion, 0.25); // the least that the tables hold
}

// Taps that the tables of this method have: what is composed of two faces needs two of each at most.
const int entryTaps = method > 1 && method < 100 && !isSmooth ? 2 : 1;

Widening widening() { return distribution == 0 ? wideningGgx(entryTaps) : wideningBeckmann(entryTaps); }

vec3 absorbed(float metres) { return attenuates ? exp(-metres * material.attenuation.xyz) : vec3(1.0); }

WeightedBeam weighted(ComposedTap tap, vec3 origin, float inside, vec3 weight) {
    WeightedBeam w;
    w.beam = straightBeam(origin, tap.direction, tap.sigma);
    w.beam.inner = tap.inner;
    w.beam.carried = tap.carried;
    w.beam.inside = inside;
    w.weight = tap.weight * weight;
    return w;
}

WeightedBeam noBeam(vec3 origin, vec3 direction) {
    WeightedBeam w;
    w.beam = straightBeam(origin, direction, 0.0);
    w.weight = vec3(0.0);
    return w;
}

MirrorBeams noMirror(Surface s) {
    MirrorBeams mirror;
    mirror.core = noBeam(s.position, s.n);
    mirror.rest = mirror.core;
    return mirror;
}

WeightedBeam mirrorBeam(Surface s, EnvironmentLight light, LobeTap tap) {
    WeightedBeam w;
    w.beam = straightBeam(s.position, tap.direction, tap.sigma);
    w.beam.turn = s.turn;
    w.weight = light.weight * tap.weight;
    return w;
}

vec3 farBeam(WeightedBeam w) { return w.weight * farRadiance(w.beam.direction, seenSigma(w.beam)); }

vec3 farMirror(MirrorBeams mirror) {
    vec3 sum = farBeam(mirror.core);
    if (lobeTaps > 1) sum += farBeam(mirror.rest);
    return sum;
}

// n as another ray finds it, `apart` from the one that it is known for.
ExitSurface exitBeside(ExitSurface s, vec3 direction, vec3 apart) {
    ExitSurface other = s;
    vec3 along = direction - dot(direction, s.n) * s.n;
    vec3 t = along * inversesqrt(max(dot(along, along), 1e-12)); // along n every plane is the plane of incidence: no turn
    vec3 b = cross(s.n, t);
    other.n = normalize(s.n + s.turn.x * dot(apart, t) * t + s.turn.y * dot(apart, b) * b);
    return other;
}

// Of a face of the solid's, as the tables have it or, where nothing scatters, Fresnel and Snell themselves.
InterfaceEnergy faceEnergy(float cosTheta, float alpha, float eta) {
    InterfaceEnergy e;
    if (isSmooth) {
        e.transmitted = fresnelTransmittedAt(cosTheta, eta);
        e.reflected = 1.0 - e.transmitted;
    } else {
        e = fetchInterfaceEnergy(interfaceEnergyTable, cosTheta, alpha, eta);
    }
    return e;
}

// wo -> where light goes on beyond the face; along -n where it is all thrown back, which has no weight.
vec3 bentBy(vec3 n, vec3 wo, float eta) {
    vec3 bent = refractAbout(wo, n, eta);
    return dot(bent, bent) > 0.0 ? bent : -n;
}

InnerTap enteringTap(int tap, Surface s, float eta, float energy) {
    InnerTap inner;
    if (isSmooth) {
        inner.direction = bentBy(s.n, s.wo, eta);
        inner.sigma = 0.0;
        inner.weight = energy;
    } else {
        inner = fetchInnerTap(interfaceLobeTable, tap, entryTaps, s.wo, s.n, s.alpha, eta, energy);
    }
    return inner;
}

// One tap through the face that it meets, by one tap that stands for all of it.
ComposedTap leavingTap(InnerTap inner, ExitSurface s, Widening k) {
    ComposedTap tap;
    float cosTheta = dot(inner.direction, s.n);
    float through;
    if (isSmooth) {
        tap.direction = bentBy(-s.n, -inner.direction, s.eta);
        tap.sigma = 0.0;
        tap.inner = 0.0;
        tap.carried = 0.0;
        through = fresnelTransmittedAt(cosTheta, s.eta);
    } else {
        ExitView seen = seeExit(inner, true, s, k);
        through = fetchExitEnergy(interfaceEnergyTable, seen, s);
        tap = fetchComposedTap(interfaceLobeTable, 0, entryTaps, inner, seen, s, through);
    }
    tap.weight = cosTheta > 0.0 ? inner.weight * through : 0.0;
    return tap;
}

InteriorView interiorCamera() { return interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy); }

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
    float left;          // its energy, of which so much gets out in the end:
    float escapes;
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

    InteriorView view = interiorCamera();
    float guess = interiorPairs > 0 ? interiorThickness(interior, view, ivec2(gl_FragCoord.xy), objectId()) : 0.0;
    vec3 from = s.position;
    float run = 0.0;
    for (int bounce = 0; bounce <= mostBounces; ++bounce) {
        if (interiorPairs > 0) {
            ExitHit hit = findExit(interior, view, interiorPairs, objectId(), from, p.ray.direction, guess, bounce > 0);
            if (hit.found > 0.0) {
                run += hit.distance;
                p.last.n = hit.n;
                p.last.alpha = hit.alpha;
                p.last.turn = exitTurn(dot(p.ray.direction, hit.n), run, hit.curvature);
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
        InterfaceEnergy face = faceEnergy(max(seen.cosTheta, 0.0), seen.alphaReflected, invIor);
        float thrownBack = p.ray.weight * face.reflected;
        // Of what is thrown back again and again, each time with the same shares, so much gets out: single scattering loses
        // the rest. A smooth face loses nothing: below a hundredth it is the table's rounding.
        float lost = max(1.0 - face.reflected - face.transmitted - 0.01, 0.0);
        p.escapes = face.transmitted + lost > 0.0 ? face.transmitted / (face.transmitted + lost) : 1.0;
        float spread = reflectedSpread(p.ray.sigma, p.last, seen.cosTheta, k.shape);
        vec3 reflected = reflect(p.ray.direction, p.last.n);
        p.left = thrownBack;
        // Beyond the critical angle, of rough curved faces and in bodies that are not convex it wanders: of all guesses, what is
        // behind the body is nearest to brute force.
        p.leftPoint = p.lastPoint;
        p.leftDirection = -s.wo;
        p.leftSigma = max(spread, LEFT_OVER_SIGMA);
        bool isFlat = p.last.turn == vec2(0.0);
        if (interiorPairs < 2 && thrownBack < 0.5 * p.ray.weight && (isFlat || spread < LEFT_OVER_SIGMA)) {
            // Else what a convex body throws back leaves by its near face: of a plate that is the one that is seen, of a curved body the
            // one that the sphere with the same chord has there.
            vec3 near = isFlat ? s.n : normalize(p.last.n + 2.0 * dot(p.ray.direction, p.last.n) * reflected);
            vec3 outward = refractAbout(-reflected, -near, invIor);
            if (dot(outward, near) > 0.0) {
                p.leftPoint = p.lastPoint + distance(p.lastPoint, from) * reflected; // chords of one length
                p.leftDirection = outward;
                p.leftSigma = min(spread / invIor, HEMISPHERE_SIGMA); // small angles grow by the index there
            }
        }
        // Followed where most of the light is: beyond the critical angle.
        if (interiorPairs == 0 || bounce == mostBounces || thrownBack < 0.5 * p.ray.weight) break;
        p.ray.sigma = spread;
        p.ray.direction = reflected;
        p.ray.weight = thrownBack;
        from = p.lastPoint;
    }
    return p;
}

// Through both faces of a solid, or of a plate whose thickness is given.
GlassBeams throughTwoFaces(Surface s, float ior) {
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerTap core = enteringTap(0, s, ior, entered);
    Widening k = widening();
    InnerPath p = followInside(s, core, entered, 1.0 / ior, k);
    vec3 absorption = absorbed(p.path);

    GlassBeams beams;
    beams.within = -1.0;
    beams.leaving = p.first;
    beams.inner = core.direction;
    beams.rest = noBeam(p.point, s.n);
    beams.bounced = noBeam(p.lastPoint, s.n);
    if (entryTaps == 1) {
        beams.core = weighted(leavingTap(core, p.first, k), p.point, p.path, absorption);
    } else {
        InnerTap tail = enteringTap(1, s, ior, entered);
        vec3 apart = tail.direction - core.direction;
        ComposedPair pair = fetchComposedPair(interfaceEnergyTable, interfaceLobeTable, core, p.first, tail,
                                              exitBeside(p.first, core.direction, apart), k);
        beams.core = weighted(pair.core, p.point, p.path, absorption);
        // The tail leaves beside the core: as far as it ran apart inside, along the face.
        vec3 beside = p.path * apart;
        beside -= dot(beside, p.first.n) * p.first.n;
        beams.rest = weighted(pair.rest, p.point + beside, p.path, absorption);
    }
    if (interiorPairs > 0) {
        ComposedTap tap = leavingTap(p.ray, p.last, k);
        if (!p.bounced) tap.weight = 0.0;
        beams.bounced = weighted(tap, p.lastPoint, p.lastPath, absorbed(p.lastPath));
    }
    // What is left runs about as far again before it gets out.
    beams.leftOver.beam = straightBeam(p.leftPoint, p.leftDirection, p.leftSigma);
    beams.leftOver.weight = p.left * p.escapes * absorbed(2.0 * p.lastPath);

    if (holdsOpaque) {
        Meeting inside = meetBackdrop(s.position, core.direction, core.sigma, true);
        if (inside.seen && !inside.hidden && inside.distance >= 0.0 && inside.distance < p.path) {
            beams.core.beam = straightBeam(s.position, core.direction, core.sigma);
            beams.core.weight = entered * absorbed(inside.distance);
            beams.rest.weight = vec3(0.0);
            beams.bounced.weight = vec3(0.0);
            beams.leftOver.weight = vec3(0.0);
            beams.within = inside.distance;
        }
    }
    return beams;
}

// Out of the solid that the camera stands in. Radiance grows by the square of the index ratio (transmission.glsl). What is
// thrown back is left over.
GlassBeams outOfSolid(Surface s, float ior) {
    float eta = 1.0 / ior;
    InterfaceEnergy face = faceEnergy(dot(s.n, s.wo), s.alpha, eta);
    vec3 absorption = absorbed(length(s.position - frame.eye.xyz));
    GlassBeams beams;
    beams.within = -1.0;
    beams.inner = -s.wo;
    beams.leaving.n = -s.n;
    beams.leaving.alpha = s.alpha;
    beams.leaving.eta = eta;
    beams.leaving.turn = vec2(0.0);
    beams.rest = noBeam(s.position, s.n);
    beams.bounced = noBeam(s.position, s.n);
    for (int k = 0; k < entryTaps; ++k) {
        InnerTap tap = enteringTap(k, s, eta, face.transmitted);
        WeightedBeam w;
        w.beam = straightBeam(s.position, tap.direction, tap.sigma);
        w.weight = tap.weight * absorption / (eta * eta);
        if (k == 0) beams.core = w;
        else beams.rest = w;
    }
    beams.leftOver.beam = straightBeam(s.position, reflect(-s.wo, s.n), LEFT_OVER_SIGMA);
    beams.leftOver.weight = face.reflected * absorption;
    return beams;
}

// As peers do it (the Khronos viewer, three.js): one interface, moved by a thickness along the refracted ray, blurred by a level
// that grows with roughness and index.
vec3 throughStandard(Surface s, float ior) {
    vec3 scale = vec3(length(instance.worldFromMesh[0].xyz), length(instance.worldFromMesh[1].xyz),
                      length(instance.worldFromMesh[2].xyz));
    float thickness = transmission == 2 ? surfaceThickness() : 0.0;
    vec3 ray = refractAbout(s.wo, s.n, ior) * thickness * scale;
    vec4 clip = frame.clipFromWorld * vec4(s.position + ray, 1.0);
    if (!(clip.w > 0.0)) return vec3(0.0);
    float level = log2(frame.picture.x) * sqrt(s.alpha) * clamp(2.0 * ior - 2.0, 0.0, 1.0);
    vec4 seen = textureLod(screenPyramid, pixelOf(clip) / frame.picture.xy, min(level, frame.picture.w));
    vec3 light = seen.w > 0.0 ? seen.xyz / seen.w : vec3(0.0);
    return fresnelTransmittedAt(dot(s.n, s.wo), ior) * absorbed(length(ray)) * light;
}

// Index 1: nothing bends and nothing is reflected. The pixel itself, absorbed as far as the solid reaches behind it.
vec3 throughNothing() {
    float inside = 0.0;
    if (attenuates && interiorPairs > 0)
        inside = interiorThickness(interior, interiorCamera(), ivec2(gl_FragCoord.xy), objectId());
    return absorbed(inside) * texelFetch(screenPyramid, ivec2(gl_FragCoord.xy), 0).xyz;
}

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// How far a beam is looked for on the picture: what brings less than glass reflects of light that meets it squarely, 4 %, is not,
// at twice that it is in full. The environment stands in.
float looked(vec3 weight) { return looksAround ? smoothstep(0.04, 0.08, largest(weight)) : 0.0; }

// Punctual lights as a beam sees them, by its density at their directions: a Gaussian of its own width. A smooth path shows a
// point of light to nobody.
vec3 lightsAlong(Beam beam) {
    vec3 sum = vec3(0.0);
    float variance = beam.sigma * beam.sigma;
    if (!(variance > 0.0)) return sum;
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], beam.origin);
        vec3 apart = a.wi - beam.direction; // chords: within 4 % of the angle up to a radian
        sum += a.irradiance * exp(-0.5 * dot(apart, apart) / variance);
    }
    return sum / (2.0 * BSDF_PI * variance);
}

// What the beams bring: core and rest, what bounced, what is left over and the mirror's, those that are looked for each by its own
// meeting.
vec3 glassRadiance(GlassBeams beams, MirrorBeams mirror) {
    vec3 sum = vec3(0.0);
    float bounced = largest(beams.bounced.weight) > 0.0 ? 1.0 : 0.0;
    vec3 wanted = vec3(bounced, looked(mirror.core.weight + mirror.rest.weight), looked(beams.leftOver.weight));
    // Lanes of a group run as long as the longest: the way is short where nothing but the core is looked for.
    int group = 0;
    while (group < 4) {
        WeightedBeam w = beams.core;
        float share = 1.0;
        if (group == 1) {
            w = beams.bounced;
            share = wanted.x;
        } else if (group == 2) {
            w = mirror.core;
            share = wanted.y;
        } else if (group == 3) {
            w = beams.leftOver;
            share = wanted.z;
        }
        Beam part = partOf(w.beam);
        Meeting meeting = meetBackdrop(part.origin, part.direction, part.sigma, true);
        if (group == 0 && beams.within >= 0.0) {
            meeting.distance = beams.within;
            meeting.seen = true;
        }
        int members = (group == 0 && entryTaps > 1) || (group == 2 && lobeTaps > 1) ? 2 : 1;
        for (int m = 0; m < members; ++m) {
            if (m == 1) {
                w = beams.rest;
                if (group == 2) w = mirror.rest;
                part = partOf(w.beam);
            }
            sum += share * w.weight * beamRadiance(part, meeting);
            if (hasLights && group < 2) sum += w.weight * lightsAlong(w.beam);
        }
        ++group;
        if (group == 1 && wanted.x == 0.0) ++group;
        if (group == 2 && wanted.y == 0.0) ++group;
        if (group == 3 && wanted.z == 0.0) ++group;
    }
    if (hasEnvironment) sum += (1.0 - wanted.y) * farMirror(mirror);
    if (transmission == 1) return sum; // nothing is left over in a wall
    // Where it has always lost its way, the widest lookup does.
    vec3 left = interiorPairs < 2 ? farBeam(beams.leftOver) : beams.leftOver.weight * wideRadiance(beams.leftOver.beam.direction);
    return sum + (1.0 - wanted.z) * left;
}
