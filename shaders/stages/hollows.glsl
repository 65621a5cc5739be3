// hollows.glsl: light that reaches a place in a hollow of its own body, past its walls and by way of them.
// Needs    stages/surface.glsl, stages/material_features.glsl.
// Source   what rays found covered (app/needs/hollows.h) by a series of reflections: of light that the place reflects with r, walls
//          that are lit as it is send r (1 - a) / (1 - a r) of what would come without them.
// Limits   a is of the cosine lobe, for reflection lobes too: an open cone about the normal for them and walls that send the mean
//          of all around were worse (gold material ball, FLIP .37 and .34, this .30). The walls are of the place's own material.

vec3 albedoOf(Surface s, vec3 specular) {
    vec3 base = vec3(0.0);
    if (shading == 1) base = s.baseColor;
    if (shading == 3) base = (1.0 - s.metallic) * s.baseColor;
    return min(specular + (1.0 - specular) * base, vec3(1.0));
}

// Of what would come without walls, what does. specular: the reflection lobe's energy.
vec3 reachesHollow(Surface s, vec3 specular) {
    vec3 r = albedoOf(s, specular);
    float a = s.hollow;
    vec3 between = (1.0 - a) / max(1.0 - a * r, vec3(1e-3)); // all is reflected, nothing comes in
    return 1.0 - a + a * r * between;
}
