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
#include "stages/importance.glsl"
#include "stages/clearcoat.glsl"
#include "stages/weighted_lobes.glsl"
#include "stages/glass_faces.glsl"
#include "stages/glass_inside.glsl"
#include "stages/glass.glsl"
#include "stages/glass_lookups.glsl"

float throughShare(Surface s) { return s.transmission * (1.0 - s.metallic); }

// Transmittance of a film and a coat on the outer side, over that of the bare interface. The film's at the interface's two
// effective angles.
vec3 layersPass(Surface s) {
    vec3 passes = vec3(coatLeaves(s));
    if (hasFilm) {
        float c1 = dot(s.n, s.wo);
        float c2 = c1;
        float share1 = 1.0;
        if (!isSmooth && hasEnvironment) {
            LobeEnergy energy = fetchLobeEnergy(energyTable, c1, s.alpha);
            c1 = energy.cos1;
            c2 = energy.cos2;
            share1 = energy.share1;
        }
        vec3 bare = mix(bareDielectricFresnel(s, c2), bareDielectricFresnel(s, c1), share1);
        vec3 film = mix(dielectricFresnel(s, c2), dielectricFresnel(s, c1), share1);
        passes *= (1.0 - film) / max(1.0 - bare, vec3(1e-3)); // both are 0 at the horizon
    }
    return passes;
}

// Of both faces, seen from outside.
vec3 transmissionTint(Surface s) { return throughShare(s) * s.baseColor * layersPass(s); }

float glassIor() { return ofPixel(material.surface.w); } // tables and composition branch on it

// As the pixel shows it: tinted, over its footprint.
WeightedLobe seenThrough(WeightedLobe w, vec3 tint) {
    WeightedLobe seen = w;
    seen.lobe.turn = turnOverPixel(w.lobe.direction);
    seen.weight *= tint;
    return seen;
}
