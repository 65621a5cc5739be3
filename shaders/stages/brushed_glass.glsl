// brushed_glass.glsl: glass that is brushed (KHR_materials_anisotropy). The tables of an interface know one width, so each sample
// of a pixel takes the facets of one slope along the brushing, whose lobe has one: the narrow one about a normal that leans. Both
// faces; of the far one along the near one's brushing.
// Frame    world; directions unit.
// Needs    stages/material_features.glsl, interface/frame.glsl, bsdf/ggx_anisotropic.glsl.
// Source   environment/stretched_lobe.glsl, drawn in place of summed.
// Limits   a picture of one or two samples per pixel, `--method standard` and walls of no thickness have one lobe of the same
//          variance of slopes: nearer the truth than one of the width across on four of five models (tests/README.md).
#include "environment/stretched_lobe.glsl"

// Of wo to the normal, below which the share of facets is that at this cosine: a rim of 1e-8 of a ball's disc.
const float LEAST_COSINE = 1e-4;
// Of the brushing's part in the far face, squared: nearer than .06 degrees to its normal, brushing has no direction there that
// survives the rounding of normals in the interior buffer.
const float LEAST_ALONG2 = 1e-6;

const bool leansByBrush = brushing > 0 && transmission == 2 && method > 0;

struct BrushedFacets {
    vec3 n;
    float alpha;
    float weight; // of the light: 1 on average over what wo sees
};

BrushedFacets levelFacets(vec3 n, vec2 widths) {
    BrushedFacets f;
    f.n = n;
    f.alpha = sqrt(0.5 * dot(widths, widths));
    f.weight = 1.0;
    return f;
}

// wo: on n's side. Of each face a sample has its own slope, which goes neither with the other's nor with the part of lobes that it
// stands for: on that spiral twice the angle for the near face, for the far one the radius.
BrushedFacets facetsOfSample(vec3 n, vec3 wo, vec3 brush, vec2 widths, bool farFace) {
    BrushedFacets f = levelFacets(n, widths);
    vec2 part = frame.part.xy;
    if (!(leansByBrush && frame.part.z < 1.0)) return f;
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
    float across2 = STRETCHED_ACROSS * narrow2 * (1.0 + steep2) / lean;
    float along = apart * 2.0 * (1.0 + s * s) * sqrt(1.0 + s * s) * spacing / lean;
    f.alpha = min(sqrt(across2 + STRETCHED_ALONG * along * along), 1.0);
    // By the share of facets of that slope in what wo sees of all.
    float z = max(dot(wo, n), LEAST_COSINE);
    float x = apart * dot(wo, brush);
    f.weight = max(dot(wo, f.n), 0.0) * sqrt(lean) / (0.5 * (z + sqrt(z * z + x * x)));
    return f;
}

// Of the face that `inside` comes to from within, n outward.
BrushedFacets facetsOfFarFace(vec3 n, vec3 inside, vec3 brush, vec2 widths) {
    vec3 along = brush - dot(brush, n) * n;
    float size = dot(along, along);
    if (!(size > LEAST_ALONG2)) return levelFacets(n, widths); // its brushing is not known
    return facetsOfSample(n, inside, along * inversesqrt(size), widths, true);
}
