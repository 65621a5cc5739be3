// clearcoat.glsl: a clear coat over a base (KHR_materials_clearcoat).
// Needs    stages/{environment_light,punctual_lights,importance}.glsl.
// Returns  coated: radiance of base and coat; coatLeaves, coatRadiance: its parts.
// Source   bsdf/clearcoat.glsl. The coat reflects like a lossless metal, times its share.
#include "bsdf/constants.glsl"
#include "bsdf/clearcoat.glsl"

layout(binding = 40) uniform sampler2D clearcoatMap;
layout(binding = 41) uniform sampler2D clearcoatRoughnessMap;
layout(binding = 42) uniform sampler2D clearcoatNormalMap;

// The coat's own surface: its normal, its width.
Surface coatSurface(Surface s) {
    Surface coat = s;
    vec3 n = inNormal;
    if (clearcoatNormalMapUv > 0) {
        vec2 uv = mapUv(clearcoatNormalMapUv, material.clearcoatNormalRow0, material.clearcoatNormalRow1);
        n = bentNormal(texture(clearcoatNormalMap, uv).xyz * 2.0 - 1.0, material.clearcoatNormalRow1.w);
    }
    coat.n = faceViewer(unitNormal(n, gl_FrontFacing), s.wo);
    float roughness = material.clearcoat.y;
    if (clearcoatRoughnessMapUv > 0)
        roughness *= texture(clearcoatRoughnessMap,
                             mapUv(clearcoatRoughnessMapUv, material.clearcoatRoughnessRow0, material.clearcoatRoughnessRow1)).y;
    coat.alpha = roughness * roughness;
    coat.turn = turnOverPixel(reflect(-s.wo, coat.n));
    return coat;
}

float coatStrength() {
    float strength = material.clearcoat.x;
    if (clearcoatMapUv > 0) strength *= texture(clearcoatMap, mapUv(clearcoatMapUv, material.clearcoatRow0, material.clearcoatRow1)).x;
    return strength;
}

// `--method fisN` (importance.glsl): the mean over the coat's lobe.
vec3 sampledCoat(Surface coat, int n) {
    mat3 basis = frameAbout(coat.n);
    vec3 wo = transpose(basis) * coat.wo;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < n; ++i) {
        vec3 wm = ggxSampleVisible(wo, vec2(coat.alpha), hammersley(i, n));
        vec3 wi = 2.0 * dot(wo, wm) * wm - wo;
        if (!(wi.z > 0.0)) continue;
        float pdf = ggxD(tilt(wm), coat.alpha) / (2.0 * (wo.z + ggxRoot(tilt(wo), coat.alpha)));
        float weight = facetWeight(wm, coat.alpha) * ggxG1(tilt(wi), coat.alpha);
        float sigma = coat.alpha > 0.0 ? 0.35 * inversesqrt(float(n) * pdf) : 0.0;
        sum += weight * reflectedRadiance(coat, basis * wi, sigma);
        weights += weight;
    }
    return sum / max(weights, LEAST_DIVISOR);
}

// Of the environment: the lobe of a surface that reflects everything.
EnvironmentLight coatLobe(Surface coat) {
    EnvironmentLight light;
    light.edge = 0.0;
    light.weight = vec3(coat.occlusion);
    light.diffuse = vec3(0.0);
    light.base = vec3(0.0);
    if (isSmooth) {
        light.lobe.direction = reflect(-coat.wo, coat.n);
        light.lobe.sigma = 0.0;
        light.lobe.weight = 1.0;
    } else {
        light.weight *= fetchLobeEnergy(energyTable, dot(coat.n, coat.wo), coat.alpha).albedo;
        if (method == 0) light.lobe = fetchStandardLobe(lobeTable, coat.wo, coat.n, coat.alpha);
        else light.lobe = fetchReflectionLobeOf(lobeTable, 0, lobeCount, coat.wo, coat.n, coat.alpha, 0.0);
    }
    return light;
}

vec3 coatEnvironment(Surface coat) {
    EnvironmentLight light = coatLobe(coat);
    return light.weight * (method >= 100 ? sampledCoat(coat, method - 100) : reflectedLight(coat, light));
}

vec3 coatLights(Surface coat) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < ofPixel(frame.counts.x); ++i) {
        Arrival a = arrivalFrom(lights[i], coat.position);
        Facet f = reflectionFacet(a.wi, coat.wo, coat.n, 1.5); // its g is not used
        if (!f.exists) continue;
        vec3 light = a.irradiance * (materialLobe(coat, f) * f.wi.z);
        if (neighbourKinds != 0 || lighting > 1)
            light *= lightPasses(lights[i], a, coat.position, unitNormal(inNormal, gl_FrontFacing));
        sum += light;
    }
    return sum;
}

// The share that the base keeps.
float coatLeaves(Surface s) {
    if (!hasCoat) return 1.0;
    return coatPasses(coatStrength(), dot(coatSurface(s).n, s.wo));
}

// Of what it reflects itself, its share.
float coatKeeps(Surface s, Surface coat) { return coatShare(coatStrength(), dot(coat.n, s.wo)); }

vec3 coatRadiance(Surface s) {
    if (!hasCoat) return vec3(0.0);
    Surface coat = coatSurface(s);
    vec3 sum = vec3(0.0);
    if (gathersLight) sum += coatEnvironment(coat);
    if (hasLights) sum += coatLights(coat);
    return coatKeeps(s, coat) * sum;
}

vec3 coated(Surface s, vec3 base) { return coatLeaves(s) * base + coatRadiance(s); }
