// glass_faces.glsl: reflection and transmission at single faces of glass.
// Frame    world; directions unit. eta = n_far / n_near of the face in question.
// Needs    stages/surface.glsl, interface/material.glsl.
// Source   refraction/composition.glsl; Snell and Fresnel where nothing scatters.
#include "bsdf/constants.glsl"
#include "bsdf/transmission.glsl"
#include "refraction/composition_fetch.glsl"

layout(binding = 22) uniform sampler3D interfaceEnergyTable;
layout(binding = 23) uniform sampler3D interfaceLobeTable;

// KHR_materials_dispersion: red and blue to both sides of the IOR, by a fortieth of (ior - 1) times the dispersion each.
float dispersedIor(float ior, float dispersion, int channel) {
    return max(ior + (float(channel) - 1.0) * 0.025 * (ior - 1.0) * dispersion, 0.25); // the least that the tables hold
}

// Lobes that the tables of this method have: what is composed of two faces needs two of each at most.
const int entryLobes = method > 1 && method < 100 && !isSmooth ? 2 : 1;

Widening widening() { return distribution == 0 ? wideningGgx(entryLobes) : wideningBeckmann(entryLobes); }

// n where another ray meets the face, `apart` from the ray that n is of.
ExitSurface exitBeside(ExitSurface s, vec3 direction, vec3 apart) {
    ExitSurface other = s;
    vec3 along = direction - dot(direction, s.n) * s.n;
    vec3 t = along * inversesqrt(max(dot(along, along), LEAST_LENGTH2)); // along n every plane is the plane of incidence: no turn
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

// wo -> where light goes on beyond the face; along -n where all is internally reflected, which has no weight.
vec3 bentBy(vec3 n, vec3 wo, float eta) {
    vec3 bent = refractAbout(wo, n, eta);
    return dot(bent, bent) > 0.0 ? bent : -n;
}

InnerLobe enteringLobe(int lobe, Surface s, float eta, float energy) {
    InnerLobe inner;
    if (isSmooth) {
        inner.direction = bentBy(s.n, s.wo, eta);
        inner.sigma = 0.0;
        inner.weight = energy;
    } else {
        inner = fetchInnerLobe(interfaceLobeTable, lobe, entryLobes, s.wo, s.n, s.alpha, eta, energy);
    }
    return inner;
}

// One lobe through a face, as one lobe.
ComposedLobe leavingLobe(InnerLobe inner, ExitSurface s, Widening k) {
    ComposedLobe lobe;
    if (isSmooth) {
        float cosTheta = dot(inner.direction, s.n);
        lobe.direction = bentBy(-s.n, -inner.direction, s.eta);
        lobe.sigma = 0.0;
        lobe.inner = 0.0;
        lobe.carried = 0.0;
        lobe.weight = cosTheta > 0.0 ? inner.weight * fresnelTransmittedAt(cosTheta, s.eta) : 0.0;
    } else {
        lobe = fetchComposed(interfaceEnergyTable, interfaceLobeTable, entryLobes, inner, s, k);
    }
    return lobe;
}
