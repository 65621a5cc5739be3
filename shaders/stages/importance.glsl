// importance.glsl: `--method fisN`: filtered importance sampling, the yardstick for the fitted lobes: N visible facets, each with
// one lookup at the width of its share of the lobe.
// Frame    world; directions unit.
// Needs    stages/environment_light.glsl.
// Source   [ColbertKrivanek07]; sigma = 0.35 / sqrt(N pdf) for Gaussian levels. GGX facets whatever the distribution: Beckmann's
//          and Phong's are weighted by the ratio of the D.
#include "bsdf/constants.glsl"

vec2 hammersley(int i, int n) {
    float inverse = float(bitfieldReverse(uint(i))) * exp2(-32.0); // radical inverse in base 2
    return vec2((float(i) + 0.5) / float(n), inverse + 0.5 / float(n));
}

// Columns x, y, n of a frame about n, after [Duff17]'s branchless one.
mat3 frameAbout(vec3 n) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// Ratio of the material's D to GGX's at a facet.
float facetWeight(vec3 wm, float alpha) {
    if (distribution == 0) return 1.0;
    Tilt m = tilt(wm);
    float own = distribution == 1 ? beckmannD(m, alpha) : phongD(m, phongExponent(alpha));
    float drawn = ggxD(m, alpha);
    return drawn > 0.0 ? own / drawn : 0.0;
}

// Mean radiance over the reflection lobe, to be weighted with its energy.
vec3 sampledReflection(Surface s, int n) {
    mat3 basis = brushedLobes > 0 ? brushFrame(s) : frameAbout(s.n);
    vec2 widths = brushedLobes > 0 ? brushWidths(s) : vec2(s.alpha);
    vec3 wo = transpose(basis) * s.wo;
    vec3 sum = vec3(0.0);
    vec3 weights = vec3(0.0);
    for (int i = 0; i < n; ++i) {
        vec3 wm = ggxSampleVisible(wo, widths, hammersley(i, n));
        float c = dot(wo, wm);
        vec3 wi = 2.0 * c * wm - wo;
        if (!(wi.z > 0.0)) continue;
        float d = brushedLobes > 0 ? ggxAnisoD(wm, widths) : ggxD(tilt(wm), s.alpha);
        float root = brushedLobes > 0 ? ggxAnisoRoot(wo, widths) : ggxRoot(tilt(wo), s.alpha);
        float g1 = brushedLobes > 0 ? ggxAnisoG1(wi, widths) : ggxG1(tilt(wi), s.alpha);
        vec3 weight = facetWeight(wm, s.alpha) * materialFresnel(s, c) * g1;
        float sigma = s.alpha > 0.0 ? 0.35 * inversesqrt(float(n) * d / (2.0 * (wo.z + root))) : 0.0;
        sum += weight * reflectedRadiance(s, basis * wi, sigma);
        weights += weight;
    }
    return sum / max(weights, vec3(LEAST_DIVISOR));
}

vec3 sampledLight(Surface s, int n) {
    EnvironmentLight light = environmentLobe(s);
    return light.diffuse + light.weight * sampledReflection(s, n);
}
