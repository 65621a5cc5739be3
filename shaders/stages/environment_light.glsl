// environment_light.glsl: reflected and diffuse light of the environment: lookups of the Gaussian-prefiltered environment, and one
// of the irradiance. Reflection: energy times the radiance in the lobe's direction at its width. Diffuse: glTF's base under it.
// Needs    stages/reflectance.glsl, stages/surroundings.glsl.
// Source   app/README.md, "The method"; environment/lobe_table.glsl; [KullaConty17] for --multiscatter.
#include "bsdf/constants.glsl"
#include "environment/lobe_table_fetch.glsl"

layout(binding = 19) uniform sampler2D energyTable;
layout(binding = 20) uniform sampler3D lobeTable;

float meanOf(vec3 color) { return (color.x + color.y + color.z) / 3.0; }

// The mean over the hemisphere of a lossless surface's albedo, 2 int E(c) c dc, by Gauss-Jacobi quadrature with two nodes
// (weight c on [0, 1]; exact for cubics).
float meanAlbedo(float alpha) {
    float a = fetchLobeEnergy(energyTable, 0.355051, alpha).albedo;
    float b = fetchLobeEnergy(energyTable, 0.844949, alpha).albedo;
    return 0.363917 * a + 0.636083 * b;
}

const bool scattersAgain = multipleScattering && !isSmooth; // constants, so that what they leave out binds nothing

// The metallic share of the material: only metals keep all of the light that is scattered between facets outside.
vec3 multiplyScattered(Surface s, float albedo, vec3 meanFresnel) {
    float metal = shading == 2 || shading == 4 ? 1.0 : shading == 3 ? s.metallic : 0.0;
    return metal * (1.0 - albedo) * multipleFresnelRgb(meanFresnel, meanAlbedo(s.alpha));
}

// What arrives by a lobe about a reflected direction: from neighbours where there are any.
vec3 reflectedRadiance(Surface s, vec3 direction, float sigma) {
    float seen = sqrt(sigma * sigma + s.turn);
    if (neighbourKinds == 0) return farRadiance(direction, seen);
    return surroundingRadiance(s.position, s.n, direction, seen, farRadiance(direction, seen), LEAST_SHARE);
}

// Two lobes as one of the same mean and variance (per axis half of the squared distances).
ReflectionLobe mergedLobes(ReflectionLobe a, ReflectionLobe b) {
    ReflectionLobe merged = a;
    float share = b.weight / max(a.weight + b.weight, LEAST_DIVISOR);
    vec3 apart = b.direction - a.direction;
    merged.sigma = sqrt(mix(a.sigma * a.sigma, b.sigma * b.sigma, share) + 0.5 * share * (1.0 - share) * dot(apart, apart));
    merged.direction = normalize(a.direction + share * apart);
    merged.weight = a.weight + b.weight;
    return merged;
}

// Dielectrics reflect little: the environment by each of their lobes, neighbours by one that stands for all.
const bool mergesLobes = neighbourKinds != 0 && shading == 1 && lobeCount > 1;

// A quarter of a step of 8 bits of all that the surface sends: of little light a little share is not seen.
float leastShareOf(vec3 weight, vec3 all) {
    return max(0.25 / max(meanOf(weight) / max(meanOf(all), LEAST_WEIGHT), LEAST_SHARE), 1.0) * LEAST_SHARE;
}

// What the lobes bring, the first of which is given. weight: of it, in what the surface sends beside `base`.
vec3 mergedRadiance(Surface s, ReflectionLobe first, float edge, vec3 weight, vec3 base) {
    ReflectionLobe lobe = first;
    ReflectionLobe merged = first;
    vec3 far = vec3(0.0);
    for (int k = 0; k < lobeCount; ++k) {
        if (k > 0) {
            lobe = fetchReflectionLobeOf(lobeTable, k, lobeCount, s.wo, s.n, s.alpha, edge);
            merged = mergedLobes(merged, lobe);
        }
        far += lobe.weight * farRadiance(lobe.direction, sqrt(lobe.sigma * lobe.sigma + s.turn));
    }
    float sigma = sqrt(merged.sigma * merged.sigma + s.turn);
    return surroundingRadiance(s.position, s.n, merged.direction, sigma, far, leastShareOf(weight, weight + base));
}

#include "stages/brushed.glsl"
#include "stages/hollows.glsl"
#include "stages/neighbour_light.glsl"

// The reflection lobe: its radiance counts times the weight. And the rest of the environment's light: the diffuse base, and
// multiple scattering.
struct EnvironmentLight {
    ReflectionLobe lobe; // the first of lobeCount
    float edge;  // where the table is read
    vec3 weight;
    vec3 diffuse;
    vec3 base;   // albedo of the diffuse base
    vec3 around; // irradiance about the normal, where the surface sends any of it
};

const bool hasBase = shading == 1 || shading == 3;
const bool takesIrradiance = hasBase || scattersAgain;

vec3 irradianceAround(Surface s) {
    if (neighbourKinds == 0 || transmission != 0) return wideRadiance(s.n);
    if (interpolatesNeighbours) return max(wideRadiance(s.n) + interpolatedIrradiance(), vec3(0.0));
    return surroundingIrradiance(s.position, s.n);
}

EnvironmentLight environmentLobe(Surface s) {
    float cosO = dot(s.n, s.wo);
    EnvironmentLight light;
    float albedo = 1.0;
    vec3 reflectance;
    if (isSmooth) {
        reflectance = materialFresnel(s, cosO);
        light.edge = 0.0;
        light.lobe.direction = reflect(-s.wo, s.n);
        light.lobe.sigma = 0.0;
        light.lobe.weight = 1.0;
    } else {
        float width = brushedLobes > 0 ? stretchedEnergyAlpha(s.wo * brushFrame(s), brushWidths(s)) : s.alpha;
        LobeEnergy energy = fetchLobeEnergy(energyTable, cosO, width);
        albedo = energy.albedo;
        reflectance = lobeMeanRgb(energy, materialFresnel(s, energy.cos1), materialFresnel(s, energy.cos2));
        // At a constant angle Fresnel's branches would ask for the material's numbers alone (of_pixel.glsl).
        light.edge = edgeShare(meanOf(materialFresnel(s, ofPixel(1.0))), meanOf(reflectance));
        if (method == 0) light.lobe = fetchStandardLobe(lobeTable, s.wo, s.n, s.alpha);
        else light.lobe = fetchReflectionLobeOf(lobeTable, 0, lobeCount, s.wo, s.n, s.alpha, light.edge);
    }
    light.weight = s.occlusion * albedo * reflectance;
    light.diffuse = vec3(0.0);
    light.base = vec3(0.0);
    light.around = vec3(0.0);

    if (takesIrradiance) {
        light.around = irradianceAround(s);
        if (hasBase) {
            vec3 angles = diffuseAngles(cosO);
            vec3 fresnel = mix(dielectricFresnel(s, angles.y), dielectricFresnel(s, angles.x), angles.z);
            float under = baseUnder(s, fresnel);
            light.base = under * baseReflected(s);
            light.diffuse += light.base * light.around;
            if (passesDiffuse) {
                vec3 behind = wideRadiance(-s.n);
                if (neighbourKinds != 0) behind = surroundingIrradiance(s.position, -s.n);
                light.diffuse += under * basePassed(s) * behind;
            }
        }
        if (scattersAgain) light.diffuse += multiplyScattered(s, albedo, reflectance) * light.around;
    }
    light.diffuse *= s.occlusion;
    return light;
}

// Of the environment alone.
vec3 farLobes(Surface s, EnvironmentLight light) {
    vec3 sum = vec3(0.0);
    ReflectionLobe lobe = light.lobe;
    for (int k = 0; k < lobeCount; ++k) {
        if (lobeCount > 1) {
            if (k > 0) lobe = fetchReflectionLobeOf(lobeTable, k, lobeCount, s.wo, s.n, s.alpha, light.edge);
        }
        sum += lobe.weight * farRadiance(lobe.direction, sqrt(lobe.sigma * lobe.sigma + s.turn));
    }
    return sum;
}

vec3 reflectedLight(Surface s, EnvironmentLight light) {
    if (interpolatesNeighbours) return max(farLobes(s, light) + interpolatedReflected(), vec3(0.0));
    if (mergesLobes) return mergedRadiance(s, light.lobe, light.edge, light.weight, light.base);
    vec3 sum = vec3(0.0);
    ReflectionLobe lobe = light.lobe;
    for (int k = 0; k < lobeCount; ++k) { // in one place: see stages/glass_lookups.glsl
        if (lobeCount > 1) { // a constant: one lobe reads no table here
            if (k > 0) lobe = fetchReflectionLobeOf(lobeTable, k, lobeCount, s.wo, s.n, s.alpha, light.edge);
        }
        sum += lobe.weight * reflectedRadiance(s, lobe.direction, lobe.sigma);
    }
    return sum;
}

vec3 environmentLight(Surface s) {
    EnvironmentLight light = environmentLobe(s);
    if (brushedLobes > 0) return light.diffuse + light.weight * brushedRadiance(s, light.edge);
    vec3 all = light.diffuse + light.weight * reflectedLight(s, light);
    if (hasHollows) all *= reachesHollow(s, light.weight);
    return all;
}

// All lobes but the first as one: for glass, where little is reflected. Weight 0 if there is but one.
ReflectionLobe mergedTail(Surface s, EnvironmentLight light) {
    ReflectionLobe merged = light.lobe;
    merged.weight = 0.0;
    for (int k = 1; k < lobeCount; ++k)
        merged = mergedLobes(merged, fetchReflectionLobeOf(lobeTable, k, lobeCount, s.wo, s.n, s.alpha, light.edge));
    return merged;
}
