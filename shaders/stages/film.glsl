// film.glsl: a thin film on the substrate (KHR_materials_iridescence): its reflectance in place of the bare one.
// Needs    stages/surface.glsl.
// Source   bsdf/thin_film.glsl.
#include "bsdf/thin_film.glsl"

// bare: the substrate's own reflectance at this cosine; f0: at normal incidence.
vec3 underFilm(Surface s, float c, vec3 bare, vec3 f0) {
    if (!hasFilm) return bare;
    vec3 base = vec3(filmBaseIor(f0.x), filmBaseIor(f0.y), filmBaseIor(f0.z));
    return mix(bare, filmFresnel(c, material.film.y, s.filmThickness, base), s.filmShare);
}
