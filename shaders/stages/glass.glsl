// glass.glsl: the light that comes through a surface of glass, as beams that leave it.
// Frame    world, metres; directions unit. eta = n_far / n_near of the face in question.
// Needs    stages/glass_beams.glsl, stages/glass_faces.glsl, stages/glass_inside.glsl, stages/object.glsl.
// Source   DESIGN.md §2 (1)-(5).
// Energy   what the first face lets in either leaves where the ray first comes to a face, or is thrown back there and is followed
//          to the next, or is left over, which takes one lookup.

vec3 absorbed(float metres) { return attenuates ? exp(-metres * material.attenuation.xyz) : vec3(1.0); }

// How the light of a surface of a solid goes on inside.
InnerPath followInside(Surface s, float ior) {
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerTap core = enteringTap(0, s, ior, entered);
    return followFaces(s, entering(s, core, entered), false, 1.0 / ior, widening());
}

// What leaves by the first face that the light comes to.
GlassBeams composedBeams(Surface s, float ior, InnerPath p) {
    float entered = p.first.ray.weight;
    InnerTap core = enteringTap(0, s, ior, entered);
    Widening k = widening();
    vec3 absorption = absorbed(p.first.run);
    GlassBeams beams;
    beams.within = -1.0;
    beams.leaving = p.first.face;
    beams.inner = core.direction;
    beams.rest = noBeam(p.first.point, s.n);
    beams.bounced = noBeam(p.last.point, s.n);
    beams.leftOver = beams.bounced;
    if (entryTaps == 1) {
        beams.core = weighted(leavingTap(core, p.first.face, k), p.first.point, p.first.run, absorption);
    } else {
        InnerTap tail = enteringTap(1, s, ior, entered);
        vec3 apart = tail.direction - core.direction;
        ComposedPair pair = fetchComposedPair(interfaceEnergyTable, interfaceLobeTable, core, p.first.face, tail,
                                              exitBeside(p.first.face, core.direction, apart), k);
        beams.core = weighted(pair.core, p.first.point, p.first.run, absorption);
        // The tail leaves beside the core: as far as it ran apart inside, along the face.
        vec3 beside = p.first.run * apart;
        beside -= dot(beside, p.first.face.n) * p.first.face.n;
        beams.rest = weighted(pair.rest, p.first.point + beside, p.first.run, absorption);
    }
    return beams;
}

// What leaves by the last face, after total reflections.
WeightedBeam reflectedInsideBeam(InnerPath p) {
    ComposedTap tap = leavingTap(p.last.ray, p.last.face, widening());
    if (!p.bounced) tap.weight = 0.0;
    return weighted(tap, p.last.point, p.last.run, absorbed(p.last.run));
}

WeightedBeam residualBeam(Surface s, float ior, InnerPath p) {
    Residual r = residualOf(s, p, 1.0 / ior, widening());
    // What is left runs about as far again from face to face as it did to come to the last.
    vec3 way = absorbed(p.last.run);
    WeightedBeam w;
    w.beam = straightBeam(r.point, r.direction, r.sigma);
    w.weight = way * (r.energy * wanderingEscapes(r.leaves, way) + p.passedBetween);
    return w;
}

// Metres to something opaque inside that ends the light that came in as `core`; negative: nothing does.
float endsInside(Surface s, InnerTap core, float run) {
    Meeting inside = meetBackdrop(s.position, core.direction, core.sigma, true);
    bool ends = inside.seen && !inside.hidden && inside.distance >= 0.0 && inside.distance < run;
    return ends ? inside.distance : -1.0;
}

// All that is seen then is what the light ends at.
GlassBeams beamsEndingInside(GlassBeams beams, Surface s, InnerTap core, float entered, float within) {
    if (within < 0.0) return beams;
    GlassBeams ended = beams;
    ended.core.beam = straightBeam(s.position, core.direction, core.sigma);
    ended.core.weight = entered * absorbed(within);
    ended.rest.weight = vec3(0.0);
    ended.bounced.weight = vec3(0.0);
    ended.leftOver.weight = vec3(0.0);
    ended.within = within;
    return ended;
}

// Through both faces of a solid, or of a plate whose thickness is given.
GlassBeams throughTwoFaces(Surface s, float ior) {
    InnerPath p = followInside(s, ior);
    GlassBeams beams = composedBeams(s, ior, p);
    if (interiorPairs > 0) beams.bounced = reflectedInsideBeam(p);
    beams.leftOver = residualBeam(s, ior, p);
    if (!holdsOpaque) return beams;
    InnerTap core = enteringTap(0, s, ior, p.first.ray.weight);
    return beamsEndingInside(beams, s, core, p.first.ray.weight, endsInside(s, core, p.first.run));
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
        inside = interiorThickness(interior, interiorCamera(), picturePixel(), objectId());
    return absorbed(inside) * texelFetch(screenPyramid, picturePixel(), 0).xyz;
}
