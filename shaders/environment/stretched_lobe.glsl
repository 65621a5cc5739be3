// stretched_lobe.glsl: the reflection lobe of a brushed surface (GGX of two widths) as lobes of isotropic surfaces about normals
//          that lean along the wider way.
// Frame    local, n = +z, x along the wider way; wo unit, wo.z >= 0.
// alpha    slope widths, alpha.x >= alpha.y > 0.
// Returns  stretchedParts: how many parts make a lobe that shows no beads, 2 to 8. stretchedPart: the k-th of `count`: unit normal,
//          width, and its weight beside the others. stretchedEnergyAlpha: the width of the isotropic surface that reflects as much
//          towards wo and whose two effective angles stand for those of the lobe.
// Source   ours. Slopes along x have the marginal distribution of GGX; what an isotropic lobe of width alpha.y has of them is taken
//          off. Even steps of that distribution between the slopes that wo sees and that reflect it above the surface, weighted by
//          visible normals [Heitz14] and the shadowing of where they reflect to.
// Limits   error by widths and parts: tests/bench/stretched_lobes.cpp. Separable shadowing; among the parts none across. Albedos of
//          stretchedEnergyAlpha: rms .02, worst .1.
#ifndef GG_ENVIRONMENT_STRETCHED_LOBE_GLSL
#define GG_ENVIRONMENT_STRETCHED_LOBE_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/ggx_anisotropic.glsl"

struct StretchedPart {
  vec3 n;
  float alpha;
  float weight;
};

// Spacings of parts are about as wide as the lobe of one part: the distribution's middle half is 1.15 widths wide.
int stretchedParts(vec2 alpha) {
  float ratio = alpha.x / max(alpha.y, 1e-3); // as ggxAnisoWidths bounds it
  return ratio < 1.5 ? 2 : ratio < 3.0 ? 4 : ratio < 6.0 ? 6 : 8;
}

// That of the same variance of slopes, and as much more or less as facets along the way of wo show and shadow: fitted to visible
// normals, widths from .02 to 1, to 80 degrees.
float stretchedEnergyAlpha(vec3 wo, vec2 alpha) {
  float mean = 0.5 * (alpha.x * alpha.x + alpha.y * alpha.y);
  float apart = alpha.x * alpha.x - alpha.y * alpha.y;
  float side = wo.x * wo.x - wo.y * wo.y;
  return sqrt(mean + apart * side * (0.24 - 0.46 * alpha.x)); // between the widths: |side| <= 1
}

// Distribution of slopes s along x, in widths: (1 + s / sqrt(1 + s²)) / 2, and its inverse.
float stretchedQuantile(float s) { return 0.5 + 0.5 * s * inversesqrt(1.0 + s * s); }

float stretchedSlope(float quantile) {
  float v = clamp(2.0 * quantile - 1.0, -0.9999, 0.9999);
  return v * inversesqrt(1.0 - v * v);
}

// What the parts take of a lobe's widths, fitted to brute force (the command above): of GGX's slopes across where those along are
// known, which are Student's t of three degrees of freedom, not two, and of two thirds of the variance (less of them is known where
// the widths are nearer each other); and of the variance of one part's spacing along.
const float STRETCHED_ACROSS = 0.55;
const float STRETCHED_ALONG = 0.03;

// Variance of slopes across in the parts.
float stretchedAcross(vec2 alpha) {
  float ratio = alpha.y / alpha.x;
  return mix(STRETCHED_ACROSS, 1.0, ratio * ratio * ratio) * alpha.y * alpha.y;
}

// shift: of all parts, in spacings, [-1/2, 1/2]; sharpness: the share of the spacing that each part keeps as its width, (0, 1].
StretchedPart stretchedPart(vec3 wo, vec2 alpha, int k, int count, float shift, float sharpness) {
  float apart = sqrt(max(alpha.x * alpha.x - alpha.y * alpha.y, LEAST_LENGTH2));
  // Slopes that reflect wo above the horizon: z s² + 2 x s - z < 0 for a normal (-s, 0, 1).
  float z = max(wo.z, LEAST_COSINE);
  float root = sqrt(wo.x * wo.x + z * z);
  float low = stretchedQuantile(-(root + wo.x) / (z * apart));
  float high = stretchedQuantile((root - wo.x) / (z * apart));
  float spacing = (high - low) / float(count);
  float s = stretchedSlope(low + (float(k) + 0.5 + shift) * spacing);
  float slope = apart * s;
  float lean = 1.0 + slope * slope;

  StretchedPart part;
  part.n = vec3(-slope, 0.0, 1.0) * inversesqrt(lean);
  // Across, slopes are wider where they are steep along; as angles about the leaning normal both are narrower.
  float across2 = stretchedAcross(alpha) * (1.0 + slope * slope / (alpha.x * alpha.x)) / lean;
  // The spacing as a length of slopes, by the derivative of stretchedSlope.
  float along = sharpness * apart * 2.0 * (1.0 + s * s) * sqrt(1.0 + s * s) * spacing / lean;
  part.alpha = min(sqrt(across2 + STRETCHED_ALONG * along * along), 1.0);
  float c = dot(wo, part.n);
  vec3 wi = 2.0 * c * part.n - wo;
  // Visible facets of slopes along alone project to (z + sqrt(z² + (apart x)²)) / 2.
  float visible = 0.5 * (z + sqrt(z * z + apart * apart * wo.x * wo.x));
  part.weight = spacing * max(c, 0.0) / (part.n.z * visible) * ggxAnisoG1(wi, alpha);
  return part;
}

#endif
