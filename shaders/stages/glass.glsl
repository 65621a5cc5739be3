// glass.glsl: light that comes through a surface of glass, by taps of the tables.
// Frame    world, metres; directions unit. eta = n_far / n_near of the face in question.
// Needs    stages/surface.glsl, stages/surroundings.glsl, interface/material.glsl, stages/object.glsl.
// Source   DESIGN.md §2 (1)-(5); refraction/composition.glsl; refraction/exit_search.glsl.
// Energy   what the first face lets in either leaves where the ray first comes to a face, or is thrown back there and is followed
//          to the next, or is what is left over, which takes one wide lookup of the environment.
#include "bsdf/transmission.glsl"
#include "refraction/composition_fetch.glsl"
#include "refraction/exit_search_fetch.glsl"

layout(binding = 22) uniform sampler3D interfaceEnergyTable;
layout(binding = 23) uniform sampler3D interfaceLobeTable;
layout(binding = 26) uniform usampler2DArray interior; // stages/interior.frag

layout(constant_id = 40) const int interiorPairs = 1; // of front and back faces
layout(constant_id = 42) const int mostBounces = 2;   // total reflections that are followed

// What the beams of one pixel have in common.
struct Ending {
    Meeting meeting;
    vec3 origin; // of the core
    float inside; // metres
};

const float LEFT_OVER_SIGMA = 0.5; // radians: light that has lost its way

// Taps that a table of this method has, for a lobe that is composed of two.
int tapCount() { return method >= 2 && method <= 4 ? method : 1; }
int entryTaps() { return tapCount() > 1 ? 2 : 1; }

Widening widening() { return distribution == 0 ? wideningGgx(entryTaps()) : wideningBeckmann(entryTaps()); }

vec3 absorbed(float metres) { return attenuates ? exp(-metres * material.attenuation.xyz) : vec3(1.0); }

Beam beamOf(ComposedTap tap, vec3 origin, float inside) {
    Beam beam;
    beam.origin = origin;
    beam.direction = tap.direction;
    beam.sigma = tap.sigma;
    beam.inner = tap.inner;
    beam.carried = tap.carried;
    beam.inside = inside;
    return beam;
}

// n as another ray finds it, `apart` from the one that it is known for.
ExitSurface exitBeside(ExitSurface s, vec3 direction, vec3 apart) {
    ExitSurface other = s;
    vec3 along = direction - dot(direction, s.n) * s.n;
    if (dot(along, along) > 1e-12) {
        vec3 t = normalize(along);
        vec3 b = cross(s.n, t);
        other.n = normalize(s.n + s.turn.x * dot(apart, t) * t + s.turn.y * dot(apart, b) * b);
    }
    return other;
}

ExitSurface exitOf(ExitHit hit, vec3 direction, float path, float eta) {
    ExitSurface s;
    s.n = hit.n;
    s.alpha = hit.alpha;
    s.eta = eta;
    s.turn = exitTurn(dot(direction, hit.n), path, hit.curvature);
    return s;
}

// The opposite face of a plate: of a thin wall, or of a mesh that has no far side, whose thickness is given.
ExitSurface plateExit(Surface s, float eta) {
    ExitSurface plate;
    plate.n = -s.n;
    plate.alpha = s.alpha;
    plate.eta = eta;
    plate.turn = vec2(0.0);
    return plate;
}

// Light through the exit for the taps of the entry. `meeting` of the core is found on the way.
vec3 throughExit(InnerTap core, InnerTap tail, ExitSurface leaving, vec3 point, float path) {
    Widening k = widening();
    if (entryTaps() == 1) {
        ComposedTap tap = fetchComposed(interfaceEnergyTable, interfaceLobeTable, core, leaving, k);
        if (!(tap.weight > 0.0)) return vec3(0.0);
        return tap.weight * beamRadiance(beamOf(tap, point, path), meetBackdrop(point, tap.direction, true));
    }
    vec3 apart = tail.direction - core.direction;
    ComposedPair pair = fetchComposedPair(interfaceEnergyTable, interfaceLobeTable, core, leaving, tail,
                                          exitBeside(leaving, core.direction, apart), k);
    if (!(pair.core.weight + pair.rest.weight > 0.0)) return vec3(0.0);
    Meeting meeting = meetBackdrop(point, pair.core.weight > 0.0 ? pair.core.direction : pair.rest.direction, true);
    vec3 sum = vec3(0.0);
    if (pair.core.weight > 0.0) sum += pair.core.weight * beamRadiance(beamOf(pair.core, point, path), meeting);
    if (pair.rest.weight > 0.0) {
        // The tail leaves beside the core: as far as it ran apart inside, along the face.
        vec3 beside = path * apart;
        beside -= dot(beside, leaving.n) * leaving.n;
        sum += pair.rest.weight * beamRadiance(beamOf(pair.rest, point + beside, path), meeting);
    }
    return sum;
}

InteriorView interiorCamera() { return interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy); }

// The share of a rough face's reflection that its own spread is known to: a facet's tilt turns a reflected ray by 2 cos of it.
// Tables give a Gaussian of 1 / shape times the slope's width (composition.glsl, Widening).
float reflectedSpread(float sigma, ExitSurface s, float cosTheta, float shape) {
    float curved = abs(1.0 - 2.0 * s.turn.x) * abs(1.0 - 2.0 * s.turn.y * cosTheta);
    float facets = 2.0 * cosTheta * s.alpha / shape;
    return min(sqrt(sigma * sigma * curved + facets * facets), 1.0);
}

// Radiance through a solid, tint apart: nothing where the surface lets nothing in.
vec3 throughSolid(Surface s, float ior) {
    float entered = fetchInterfaceEnergy(interfaceEnergyTable, dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerTap core = fetchInnerTap(interfaceLobeTable, 0, entryTaps(), s.wo, s.n, s.alpha, ior, entered);
    InnerTap tail = core;
    if (entryTaps() > 1) tail = fetchInnerTap(interfaceLobeTable, 1, entryTaps(), s.wo, s.n, s.alpha, ior, entered);

    InteriorView view = interiorCamera();
    uint id = objectId();
    float guess = interiorThickness(interior, view, ivec2(gl_FragCoord.xy), id);
    Widening k = widening();
    vec3 point = s.position;
    vec3 light = vec3(0.0);
    float left = entered; // light that has not left yet
    float escapes = 1.0;
    float path = 0.0;
    InnerTap ray = core;
    ray.weight = entered;
    for (int bounce = 0; bounce <= mostBounces; ++bounce) {
        ExitHit hit = findExit(interior, view, interiorPairs, id, point, ray.direction, guess, bounce > 0);
        if (holdsOpaque) {
            Meeting within = meetBackdrop(point, ray.direction, true);
            if (within.seen && within.distance >= 0.0 && (within.distance < hit.distance || !(hit.found > 0.0))) {
                Beam beam;
                beam.origin = point;
                beam.direction = ray.direction;
                beam.sigma = ray.sigma;
                beam.inner = 0.0;
                beam.carried = 0.0;
                beam.inside = 0.0;
                return light + left * absorbed(path + within.distance) * beamRadiance(beam, within);
            }
        }
        if (!(hit.found > 0.0)) {
            if (bounce > 0) break;
            // No far side: a plate of the material's thickness.
            vec3 scale = vec3(length(instance.worldFromMesh[0].xyz), length(instance.worldFromMesh[1].xyz),
                              length(instance.worldFromMesh[2].xyz));
            float across = surfaceThickness() * (scale.x + scale.y + scale.z) / 3.0;
            float length = across / max(-dot(core.direction, s.n), 0.05);
            return absorbed(length) *
                   throughExit(core, tail, plateExit(s, 1.0 / ior), s.position + length * core.direction, length);
        }
        path += hit.distance;
        point = hit.point;
        ExitSurface leaving = exitOf(hit, ray.direction, path, 1.0 / ior);
        vec3 absorption = absorbed(path);
        ExitView seen = seeExit(ray, true, leaving, k);
        InterfaceEnergy face = fetchInterfaceEnergy(interfaceEnergyTable, max(seen.cosTheta, 0.0), seen.alphaReflected, leaving.eta);
        float thrownBack = ray.weight * face.reflected;
        // Of what is thrown back again and again, each time with the same shares, so much gets out: single scattering loses
        // the rest. Beyond the critical angle of a smooth face, where nothing is lost, all of it.
        float lost = 1.0 - face.reflected - face.transmitted;
        escapes = face.transmitted > lost * 1e-3 ? face.transmitted / (face.transmitted + max(lost, 0.0)) : (lost > 0.01 ? 0.0 : 1.0);
        if (bounce == 0) {
            light += absorption * throughExit(core, tail, leaving, point, path);
        } else {
            float through = fetchExitEnergy(interfaceEnergyTable, seen, leaving);
            ComposedTap tap = fetchComposedTap(interfaceLobeTable, 0, entryTaps(), ray, seen, leaving, through);
            tap.weight = ray.weight * through; // the core stands for its tail
            if (tap.weight > 0.0)
                light += absorption * tap.weight * beamRadiance(beamOf(tap, point, path), meetBackdrop(point, tap.direction, true));
        }
        left = thrownBack;
        // Followed where most of the light is: beyond the critical angle.
        bool mostly = thrownBack > 0.5 * ray.weight;
        ray.sigma = reflectedSpread(ray.sigma, leaving, seen.cosTheta, k.shape);
        ray.direction = reflect(ray.direction, leaving.n);
        ray.weight = thrownBack;
        if (!mostly) break;
    }
    // What is left runs about as far again before it finds a way out.
    if (left > 0.0) {
        Beam rest;
        rest.origin = point;
        rest.direction = ray.direction;
        rest.sigma = max(ray.sigma, LEFT_OVER_SIGMA);
        rest.inner = 0.0;
        rest.carried = 0.0;
        rest.inside = 0.0;
        Meeting meeting = nowhere();
        if (looksAround) meeting = meetBackdrop(point, ray.direction, true);
        light += left * escapes * absorbed(2.0 * path) * beamRadiance(rest, meeting);
    }
    return light;
}

// Two faces at one place.
vec3 throughWall(Surface s, float ior) {
    float entered = fetchInterfaceEnergy(interfaceEnergyTable, dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerTap core = fetchInnerTap(interfaceLobeTable, 0, entryTaps(), s.wo, s.n, s.alpha, ior, entered);
    InnerTap tail = core;
    if (entryTaps() > 1) tail = fetchInnerTap(interfaceLobeTable, 1, entryTaps(), s.wo, s.n, s.alpha, ior, entered);
    return throughExit(core, tail, plateExit(s, 1.0 / ior), s.position, 0.0);
}

// Out of the solid that the camera stands in. Radiance grows by the square of the index ratio (transmission.glsl).
vec3 outOfSolid(Surface s, float ior) {
    float eta = 1.0 / ior;
    float left = fetchInterfaceEnergy(interfaceEnergyTable, dot(s.n, s.wo), s.alpha, eta).transmitted;
    vec3 sum = vec3(0.0);
    Meeting meeting;
    for (int k = 0; k < entryTaps(); ++k) {
        InnerTap tap = fetchInnerTap(interfaceLobeTable, k, entryTaps(), s.wo, s.n, s.alpha, eta, left);
        if (k == 0) meeting = meetBackdrop(s.position, tap.direction, true);
        Beam beam;
        beam.origin = s.position;
        beam.direction = tap.direction;
        beam.sigma = tap.sigma;
        beam.inner = 0.0;
        beam.carried = 0.0;
        beam.inside = 0.0;
        sum += tap.weight * beamRadiance(beam, meeting);
    }
    return absorbed(length(s.position - frame.eye.xyz)) * sum / (eta * eta);
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

vec3 throughGlass(Surface s) {
    float ior = material.surface.w;
    if (indexIsOne) {
        // Nothing bends and nothing is reflected: the pixel itself, absorbed as far as the solid reaches behind it.
        float inside = 0.0;
        if (transmission == 2 && attenuates)
            inside = interiorThickness(interior, interiorCamera(), ivec2(gl_FragCoord.xy), objectId());
        return absorbed(inside) * texelFetch(screenPyramid, ivec2(gl_FragCoord.xy), 0).xyz;
    }
    if (method == 0) return throughStandard(s, ior);
    if (transmission == 1) return throughWall(s, ior);
    return gl_FrontFacing ? throughSolid(s, ior) : outOfSolid(s, ior);
}
