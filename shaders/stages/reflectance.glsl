// reflectance.glsl: the opaque material as a BSDF: Cook-Torrance over glTF's diffuse.
// Needs    stages/surface.glsl.
// Source   [Walter07] eq. 20; glTF 2.0 appendix B (diffuse under the specular lobe); KHR_materials_specular.
#include "bsdf/beckmann.glsl"
#include "bsdf/fresnel_conductor.glsl"
#include "bsdf/fresnel_dielectric.glsl"
#include "bsdf/fresnel_schlick.glsl"
#include "bsdf/ggx.glsl"
#include "bsdf/multiple_scattering.glsl"
#include "bsdf/phong.glsl"
#include "bsdf/reflection.glsl"
#include "stages/film.glsl"

// A dielectric whose reflectance glTF gives as a colour: reflectance at 0 and at 90 degrees.
struct SchlickPair {
    vec3 f0;
    float f90;
};

SchlickPair dielectricSchlick(Surface s) {
    // glTF: an ior of 0 means that everything is reflected.
    float ior = ofPixel(material.surface.w);
    float f0 = ior > 0.0 ? fresnelNormalIncidence(ior) : 1.0;
    SchlickPair pair;
    pair.f0 = min(f0 * s.specularColor, vec3(1.0)) * s.specular;
    pair.f90 = s.specular;
    return pair;
}

vec3 bareDielectricFresnel(Surface s, float c) {
    if (!schlickDielectric) return vec3(fresnelDielectricAt(c, material.surface.w));
    SchlickPair pair = dielectricSchlick(s);
    return pair.f0 + (vec3(pair.f90) - pair.f0) * schlickWeight(c);
}

vec3 dielectricFresnel(Surface s, float c) {
    vec3 f0 = vec3(0.0);
    if (hasFilm) f0 = schlickDielectric ? dielectricSchlick(s).f0 : vec3(fresnelNormalIncidence(material.surface.w));
    return underFilm(s, c, bareDielectricFresnel(s, c), f0);
}

vec3 metalFresnel(Surface s, float c) { return underFilm(s, c, fresnelSchlickRgb(c, s.baseColor), s.baseColor); }

// The material's reflectance at the cosine c between direction and facet; a mixture's by its parts.
vec3 materialFresnel(Surface s, float c) {
    if (shading == 4)
        return underFilm(s, c, fresnelConductorRgb(c, material.conductorN.xyz, material.conductorK.xyz), s.baseColor);
    if (shading == 2) return metalFresnel(s, c);
    vec3 dielectric = dielectricFresnel(s, c);
    return shading == 3 ? mix(dielectric, metalFresnel(s, c), s.metallic) : dielectric;
}

// D V of the material's distribution: f_r without Fresnel's factor.
float materialLobe(Surface s, Facet f) {
    if (distribution == 1) return reflectionLobe(f, beckmannD(f.h, s.alpha), beckmannV(f.wi, f.wo, s.alpha));
    if (distribution == 2) {
        float exponent = phongExponent(s.alpha);
        return reflectionLobe(f, phongD(f.h, exponent), phongV(f.wi, f.wo, exponent));
    }
    float v = correlatedSmith ? ggxVCorrelated(f.wi, f.wo, s.alpha) : ggxV(f.wi, f.wo, s.alpha);
    return reflectionLobe(f, ggxD(f.h, s.alpha), v);
}

// The same of a brushed surface: GGX of two widths.
mat3 brushFrame(Surface s) { return mat3(s.brush, cross(s.n, s.brush), s.n); }
vec2 brushWidths(Surface s) { return vec2(s.along, s.alpha); }

float brushedLobe(Surface s, vec3 wi) {
    mat3 world = brushFrame(s);
    vec3 i = wi * world;
    vec3 o = s.wo * world;
    float v = correlatedSmith ? ggxAnisoVCorrelated(i, o, brushWidths(s)) : ggxAnisoV(i, o, brushWidths(s));
    return ggxAnisoD(i + o, brushWidths(s)) * v;
}

// The share of light that reaches the diffuse base under a dielectric that reflects `fresnel`.
float baseUnder(Surface s, vec3 fresnel) {
    float under = 1.0 - max(fresnel.x, max(fresnel.y, fresnel.z));
    float base = shading == 3 ? 1.0 - s.metallic : 1.0;
    if (transmission > 0) base *= 1.0 - s.transmission;
    return base * under;
}

// Albedo of the base towards the viewer, and to the other side.
vec3 baseReflected(Surface s) { return passesDiffuse ? (1.0 - s.passedShare) * s.baseColor : s.baseColor; }
vec3 basePassed(Surface s) { return s.passedShare * s.passedColor; }

// f |wi . n| of light from the other side, as it would be scattered from this one.
vec3 passedFCos(Surface s, vec3 wi) {
    float c = dot(wi, s.n);
    if (c >= 0.0) return vec3(0.0);
    Facet f = reflectionFacet(wi - 2.0 * c * s.n, s.wo, s.n, 1.5);
    return f.exists ? baseUnder(s, dielectricFresnel(s, f.woDotM)) * basePassed(s) * (f.wi.z / BSDF_PI) : vec3(0.0);
}

// f(wi, wo) |wi . n|. Smooth surfaces (alpha = 0) show no point light: 0.
vec3 materialFCos(Surface s, vec3 wi) {
    if (passesDiffuse) {
        if (dot(wi, s.n) < 0.0) return passedFCos(s, wi);
    }
    Facet f = reflectionFacet(wi, s.wo, s.n, 1.5); // its g, which alone depends on the IOR, is not used below
    if (!f.exists) return vec3(0.0);
    float lobe = brushedLobes > 0 ? brushedLobe(s, wi) : materialLobe(s, f);
    float c = f.woDotM;
    vec3 value = materialFresnel(s, c) * lobe;
    if (shading == 1 || shading == 3) {
        value += baseUnder(s, dielectricFresnel(s, c)) * baseReflected(s) / BSDF_PI;
    }
    return value * f.wi.z;
}
