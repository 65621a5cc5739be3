// brushed_glass.glsl: glass that is brushed (KHR_materials_anisotropy). The tables of an interface know one width, so each sample
// of a pixel takes the facets of one slope along the brushing, whose lobe has one: the narrow one about a normal that leans. Both
// faces; of the far one along the near one's brushing.
// Frame    world; directions unit.
// Needs    stages/material_features.glsl, interface/frame.glsl, bsdf/ggx_anisotropic.glsl.
// Source   environment/stretched_lobe.glsl, drawn in place of summed.
// Limits   a picture of one or two samples per pixel, `--method standard` and walls of no thickness have one lobe of the same
//          variance of slopes: nearer the truth than one of the width across on four of five models (tests/README.md).
#include "bsdf/constants.glsl"
#include "environment/stretched_lobe.glsl"
#include "stages/of_pixel.glsl"

// Of the brushing's part in the far face, squared: nearer than .06 degrees to its normal, brushing has no direction there that
// survives the rounding of normals in the interior buffer.
const float LEAST_ALONG2 = 1e-6;

const bool leansByBrush = brushing > 0 && transmission == 2 && method > 0;

struct BrushedFacets {
    vec3 n;
    float alpha;
    float weight; // of the light: 1 on average over what wo sees, less what is shadowed along the brushing
    float mirrors; // the same of what they reflect
};

BrushedFacets levelFacets(vec3 n, vec2 widths) {
    BrushedFacets f;
    f.n = n;
    f.alpha = sqrt(0.5 * dot(widths, widths));
    f.weight = 1.0;
    f.mirrors = 1.0;
    return f;
}

// Shadowing of light that leaves facets about f.n by w: of the surface's widths about its own normal, over that of one facet's,
// which the tables of an interface hold. side: 1 where w is on n's side, -1 on the other.
float shadowingOver(BrushedFacets f, vec3 w, float side, vec3 n, vec3 brush, vec2 widths) {
    vec3 local = vec3(dot(w, brush), dot(w, cross(n, brush)), side * dot(w, n));
    if (!(local.z > 0.0)) return 0.0; // into the surface
    float z = min(abs(dot(w, f.n)), 1.0);
    float own = ggxG1(tilt(vec3(sqrt(1.0 - z * z), 0.0, z)), f.alpha);
    return ggxAnisoG1(local, widths) / max(own, LEAST_COSINE);
}

// wo: on n's side; eta: of the other side over this. Of each face a sample has its own slope, which goes neither with the other's
// nor with the part of lobes that it stands for: on that spiral twice the angle for the near face, for the far one the radius.
BrushedFacets facetsOfSample(vec3 n, vec3 wo, vec3 brush, vec2 widths, float eta, bool farFace) {
    BrushedFacets f = levelFacets(n, widths);
    vec2 part = frame.part.xy;
    if (!(leansByBrush && ofPixel(frame.part.z) < 1.0)) return f;
    float spacing = min(12.0 * frame.part.w, 1.0); // 1 / samples
    float quantile = farFace ? 1.0 - exp(-dot(part, part)) : fract(atan(part.y, part.x) / BSDF_PI);
    float s = stretchedSlope(clamp(quantile, 0.5 * spacing, 1.0 - 0.5 * spacing));
    float apart = sqrt(max(widths.x * widths.x - widths.y * widths.y, 0.0));
    float slope = apart * s;
    float lean = 1.0 + slope * slope;
    f.n = (n - slope * brush) * inversesqrt(lean);
    // slope² / widths.x² without a division that could be by 0: apart² is widths.x² - widths.y².
    float narrow2 = widths.y * widths.y;
    float steep2 = narrow2 < widths.x * widths.x ? s * s * (1.0 - narrow2 / (widths.x * widths.x)) : 0.0;
    float across2 = stretchedAcross(widths) * (1.0 + steep2) / lean;
    float along = apart * 2.0 * (1.0 + s * s) * sqrt(1.0 + s * s) * spacing / lean;
    f.alpha = min(sqrt(across2 + STRETCHED_ALONG * along * along), 1.0);
    // By the share of facets of that slope in what wo sees of all.
    float z = max(dot(wo, n), LEAST_COSINE);
    float x = apart * dot(wo, brush);
    float visible = max(dot(wo, f.n), 0.0) * sqrt(lean) / (0.5 * (z + sqrt(z * z + x * x)));
    vec3 passed = refract(-wo, f.n, 1.0 / eta); // 0 past the critical angle
    f.mirrors = visible * shadowingOver(f, reflect(-wo, f.n), 1.0, n, brush, widths);
    f.weight = dot(passed, passed) > 0.0 ? visible * shadowingOver(f, passed, -1.0, n, brush, widths) : f.mirrors;
    return f;
}

// Of the face that `inside` comes to from within, n outward.
BrushedFacets facetsOfFarFace(vec3 n, vec3 inside, vec3 brush, vec2 widths, float invIor) {
    vec3 along = brush - dot(brush, n) * n;
    float size = dot(along, along);
    if (!(size > LEAST_ALONG2)) return levelFacets(n, widths); // its brushing is not known
    return facetsOfSample(n, inside, along * inversesqrt(size), widths, invIor, true);
}
