// hollows.glsl: occlusion by the surface's own body, and the light that its walls send by reflection.
// Needs    stages/surface.glsl, stages/material_features.glsl.
// Source   the covered share a of the cosine lobe (app/needs/hollows.h), and a geometric series of reflections: walls of
//          reflectance r that are lit as the place is send r (1 - a) / (1 - a r) of what would arrive without them.
// Limits   a is of the cosine lobe, for reflection lobes too: an open cone about the normal for them and walls that send the mean
//          of all around were worse (gold material ball, FLIP .37 and .34, this .30). The walls are of the place's own material.

vec3 albedoOf(Surface s, vec3 specular) {
    vec3 base = vec3(0.0);
    if (shading == 1) base = s.baseColor;
    if (shading == 3) base = (1.0 - s.metallic) * s.baseColor;
    return min(specular + (1.0 - specular) * base, vec3(1.0));
}

// Factor on the light that would arrive without walls. specular: the reflection lobe's energy.
vec3 reachesHollow(Surface s, vec3 specular) {
    vec3 r = albedoOf(s, specular);
    float a = s.hollow;
    vec3 between = (1.0 - a) / max(1.0 - a * r, vec3(1e-3)); // all is reflected, no light comes in
    return 1.0 - a + a * r * between;
}
