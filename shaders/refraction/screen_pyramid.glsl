// screen_pyramid.glsl: a picture blurred by Gaussians of known variance, and which of its levels stand for a variance.
// Frame    pixels: (0, 0) the corner of the top left pixel, (0.5, 0.5) its centre.
// alpha    none; variance: per axis, in pixels² of the full picture, >= 0.
// Returns  pyramidVariance: of what a bilinear lookup of a level shows. pyramidLevel: fractional level, to be read with linear
//          filtering between levels. pyramidCoverage: share of a Gaussian's weight within the picture, in [0, 1].
//          lobeVariance: metres², of where the light of one lobe comes from. pixelsPerRadian: about a direction.
// Source   each level halves the one before through [1 3 3 1] / 8 in both directions, whose variance is 3/4 of a source
//          pixel²: level l has (4^l - 1) / 4. Bilinear interpolation adds f (1 - f) of a texel², 1/6 on average over f.
// Limits   a mixture of two levels has the variance, not the shape, of the Gaussian between them. Wider than the last level
//          counts as the last.
#ifndef GG_REFRACTION_SCREEN_PYRAMID_GLSL
#define GG_REFRACTION_SCREEN_PYRAMID_GLSL

float pyramidVariance(float level) {
  float scale = exp2(2.0 * level); // pixels² in a texel²
  return 0.25 * (scale - 1.0) + scale / 6.0;
}

float pyramidLevel(float variance, float lastLevel) {
  // Inverse of pyramidVariance at whole levels, linear in the variance between two of them: what mixing does.
  float scale = (variance + 0.25) / (0.25 + 1.0 / 6.0);
  float exact = 0.5 * log2(max(scale, 1.0));
  float below = min(floor(exact), lastLevel);
  float low = pyramidVariance(below);
  float high = pyramidVariance(below + 1.0);
  return min(below + clamp((variance - low) / (high - low), 0.0, 1.0), lastLevel);
}

// The normal distribution's integral from -infinity to x, to 0.0095: a logistic function of the same slope at 0 as fits best
// [BowlingKhasawneh09]. No picture shows the difference: it is the fade from one picture of the surroundings to another.
float normalIntegral(float x) { return 1.0 / (1.0 + exp(-1.702 * x)); }

// at, size: pixels; sigma > 0 pixels.
float pyramidCoverage(vec2 at, vec2 size, float sigma) {
  // A quarter of a pixel at least, so that a sharp lobe fades over the last pixel and not by a jump.
  float inverse = 1.0 / max(sigma, 0.25);
  float x = normalIntegral((size.x - at.x) * inverse) - normalIntegral(-at.x * inverse);
  float y = normalIntegral((size.y - at.y) * inverse) - normalIntegral(-at.y * inverse);
  return clamp(x * y, 0.0, 1.0);
}

// A lobe leaves the glass with spread sigma (radians), `carried` of which it brought from the first interface, where it
// spread by `inner` and then ran `inside` metres. After `outside` metres its offset is x1 inner inside + outside angle, with
// angle and x1 correlated through `carried`: variance outside² sigma² + 2 outside inside inner carried + inside² inner².
float lobeVariance(float sigma, float carried, float inner, float inside, float outside) {
  float offset = inside * inner;
  float angle = outside * sigma;
  return angle * angle + 2.0 * offset * outside * min(carried, sigma) + offset * offset;
}

// `focal` pixels per unit of tangent; cosine of the angle to the optical axis, in (0, 1]. A radian covers focal / cos² along
// the radius and focal / cos across it: their geometric mean.
float pixelsPerRadian(float focal, float cosine) { return focal / (cosine * sqrt(cosine)); }

#endif
