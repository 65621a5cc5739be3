// glass.glsl: the light that comes through a surface of glass, as lobes that leave it.
// Frame    world, metres; directions unit. eta = n_far / n_near of the face in question.
// Needs    stages/weighted_lobes.glsl, stages/glass_faces.glsl, stages/glass_inside.glsl, stages/object.glsl.
// Source   app/README.md, "The method"; refraction/composition.glsl.
// Energy   what the first face lets in either leaves where the ray first comes to a face, or is internally reflected there and is
//          followed to the next, or is residual, which takes one lookup.

vec3 absorbed(float metres) { return attenuates ? exp(-metres * material.attenuation.xyz) : vec3(1.0); }

// How the light of a surface of a solid goes on inside.
InnerPath followInside(Surface s, float ior) {
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerLobe core = enteringLobe(0, s, ior, entered);
    return followFaces(s, entering(s, core, entered), false, 1.0 / ior, widening());
}

// What leaves by the first face that the light comes to.
GlassLobes composedLobes(Surface s, float ior, InnerPath p) {
    float entered = p.first.ray.weight;
    InnerLobe core = enteringLobe(0, s, ior, entered);
    Widening k = widening();
    vec3 absorption = absorbed(p.first.run);
    GlassLobes lobes;
    lobes.within = -1.0;
    lobes.leaving = p.first.face;
    lobes.inner = core.direction;
    lobes.rest = noLobe(p.first.point, s.n);
    lobes.reflectedInside = noLobe(p.last.point, s.n);
    lobes.residual = lobes.reflectedInside;
    if (entryLobes == 1) {
        lobes.core = weighted(leavingLobe(core, p.first.face, k), p.first.point, p.first.run, absorption);
    } else {
        InnerLobe tail = enteringLobe(1, s, ior, entered);
        vec3 apart = tail.direction - core.direction;
        ComposedPair pair = fetchComposedPair(interfaceEnergyTable, interfaceLobeTable, core, p.first.face, tail,
                                              exitBeside(p.first.face, core.direction, apart), k);
        lobes.core = weighted(pair.core, p.first.point, p.first.run, absorption);
        // The tail leaves beside the core: as far as it ran apart inside, along the face.
        vec3 beside = p.first.run * apart;
        beside -= dot(beside, p.first.face.n) * p.first.face.n;
        lobes.rest = weighted(pair.rest, p.first.point + beside, p.first.run, absorption);
    }
    return lobes;
}

// What leaves by the last face, after total reflections.
WeightedLobe reflectedInsideLobe(InnerPath p) {
    ComposedLobe lobe = leavingLobe(p.last.ray, p.last.face, widening());
    if (!p.reflectedInside) lobe.weight = 0.0;
    return weighted(lobe, p.last.point, p.last.run, absorbed(p.last.run));
}

WeightedLobe residualLobe(Surface s, float ior, InnerPath p) {
    Residual r = residualOf(s, p, 1.0 / ior, widening());
    // The residual energy runs about as far between faces as light did on its last segment.
    vec3 way = absorbed(p.last.run);
    WeightedLobe w;
    w.lobe = lobeRay(r.point, r.direction, r.sigma);
    w.weight = way * (r.energy * internalScatteringEscapes(r.leaves, way) + p.passedBetween);
    return w;
}

// Metres to something opaque inside that ends the light that came in as `core`; negative: nothing does.
float endsInside(Surface s, InnerLobe core, float run) {
    Intersection inside = intersectScene(s.position, core.direction, core.sigma, true);
    bool ends = inside.seen && !inside.hidden && inside.distance >= 0.0 && inside.distance < run;
    return ends ? inside.distance : -1.0;
}

// Only that opaque surface is seen then.
GlassLobes lobesEndingInside(GlassLobes lobes, Surface s, InnerLobe core, float entered, float within) {
    if (within < 0.0) return lobes;
    GlassLobes ended = lobes;
    ended.core.lobe = lobeRay(s.position, core.direction, core.sigma);
    ended.core.weight = entered * absorbed(within);
    ended.rest.weight = vec3(0.0);
    ended.reflectedInside.weight = vec3(0.0);
    ended.residual.weight = vec3(0.0);
    ended.within = within;
    return ended;
}

// Through both faces of a solid, or of a plate whose thickness is given.
GlassLobes throughTwoFaces(Surface s, float ior) {
    InnerPath p = followInside(s, ior);
    GlassLobes lobes = composedLobes(s, ior, p);
    if (interiorPairs > 0) lobes.reflectedInside = reflectedInsideLobe(p);
    lobes.residual = residualLobe(s, ior, p);
    if (!holdsOpaque) return lobes;
    InnerLobe core = enteringLobe(0, s, ior, p.first.ray.weight);
    return lobesEndingInside(lobes, s, core, p.first.ray.weight, endsInside(s, core, p.first.run));
}

// Out of the solid that the camera stands in. Radiance grows by the square of the IOR ratio (transmission.glsl). What is
// reflected inside is residual.
GlassLobes outOfSolid(Surface s, float ior) {
    float eta = 1.0 / ior;
    InterfaceEnergy face = faceEnergy(dot(s.n, s.wo), s.alpha, eta);
    vec3 absorption = absorbed(length(s.position - frame.eye.xyz));
    GlassLobes lobes;
    lobes.within = -1.0;
    lobes.inner = -s.wo;
    lobes.leaving.n = -s.n;
    lobes.leaving.alpha = s.alpha;
    lobes.leaving.eta = eta;
    lobes.leaving.turn = vec2(0.0);
    lobes.rest = noLobe(s.position, s.n);
    lobes.reflectedInside = noLobe(s.position, s.n);
    for (int k = 0; k < entryLobes; ++k) {
        InnerLobe lobe = enteringLobe(k, s, eta, face.transmitted);
        WeightedLobe w;
        w.lobe = lobeRay(s.position, lobe.direction, lobe.sigma);
        w.weight = lobe.weight * absorption / (eta * eta);
        if (k == 0) lobes.core = w;
        else lobes.rest = w;
    }
    lobes.residual.lobe = lobeRay(s.position, reflect(-s.wo, s.n), RESIDUAL_SIGMA);
    lobes.residual.weight = face.reflected * absorption;
    return lobes;
}

// `--method standard`, as the Khronos viewer and three.js do it: one interface, a thickness along the refracted ray, and a pyramid
// level that grows with roughness and IOR.
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

// IOR 1: nothing bends and nothing is reflected. The pixel itself, absorbed as far as the solid reaches behind it.
vec3 throughNothing() {
    float inside = 0.0;
    if (attenuates && interiorPairs > 0)
        inside = interiorThickness(interior, interiorCamera(), picturePixel(), objectId());
    return absorbed(inside) * texelFetch(screenPyramid, picturePixel(), 0).xyz;
}
