// glass_material.glsl: a surface of glass and its lobes, as all of its passes begin.
// Frame    world, metres.
// Needs    interface/{frame,instance,lights,material}.glsl, stages/material_features.glsl, the inputs of opaque.vert.
#include "stages/surface.glsl"
#include "stages/object.glsl"
#include "stages/reflectance.glsl"
#include "stages/environment.glsl"
#include "stages/neighbours.glsl"
#include "stages/punctual_lights.glsl"
#include "stages/surroundings.glsl"
#include "stages/environment_light.glsl"
#include "stages/weighted_lobes.glsl"
#include "stages/glass_faces.glsl"
#include "stages/glass_inside.glsl"
#include "stages/glass.glsl"
#include "stages/glass_lookups.glsl"

float throughShare(Surface s) { return s.transmission * (1.0 - s.metallic); }

// Of both faces.
vec3 transmissionTint(Surface s) { return throughShare(s) * s.baseColor; }

float glassIor() { return ofPixel(material.surface.w); } // tables and composition branch on it

MirrorLobes mirrorLobes(Surface s, EnvironmentLight light) {
    MirrorLobes mirror = noMirror(s);
    mirror.core = mirrorLobe(s, light, light.lobe);
    if (lobeCount > 1) mirror.rest = mirrorLobe(s, light, mergedTail(s, light));
    return mirror;
}

// As the pixel shows it: tinted, over its footprint.
WeightedLobe seenThrough(WeightedLobe w, vec3 tint) {
    WeightedLobe seen = w;
    seen.lobe.turn = turnOverPixel(w.lobe.direction);
    seen.weight *= tint;
    return seen;
}
