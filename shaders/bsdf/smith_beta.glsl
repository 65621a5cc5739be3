// smith_beta.glsl: Smith's shadowing-masking for transmission, correlated in height: the Beta function of two Lambdas.
// Frame    any, by Tilt (half_vector.glsl).
// alpha    as the Lambdas that are passed; ggxG2Beta takes GGX's slope width.
// Returns  smithG2Beta, ggxG2Beta: [0, 1]. ggxVBeta: G2 / (4 |wi.n| |wo.n|), 0 on the horizon.
// Source   [Heitz16] 4.2, [Bourlier00]: a ray that enters at height of rank c leaves on the other side from rank 1 - c.
// Limits   1 / (1 + Lambda_i + Lambda_o), often used here, belongs to reflection: it assumes one height where light
//          enters and leaves on the same side, and lets through too much (at eta 1.5, alpha 1, 85 degrees .69 of the
//          light for .09). Relative error below 1e-11 in double, 4e-6 in float (2e-5 for Lambda 1e30).
#ifndef GG_BSDF_SMITH_BETA_GLSL
#define GG_BSDF_SMITH_BETA_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/ggx.glsl"
#include "bsdf/log1p.glsl"

// What Stirling's formula for the log of Gamma leaves out, [AS64] 6.1.41. From x = 7 the next term is below 2e-12.
float stirlingRest(float x) {
  float r = 1.0 / x;
  float r2 = r * r;
  return r * (1.0 / 12.0 - r2 * (1.0 / 360.0 - r2 * (1.0 / 1260.0 - r2 * (1.0 / 1680.0 - r2 / 1188.0))));
}

// B(1 + lambdaI, 1 + lambdaO). Six steps of the recurrence B(x, y) = B(x + 1, y + 1) (x + y)(x + y + 1) / (x y) lift
// both arguments to 7 and more; there x^x y^y / (x + y)^(x + y) is one exponential of two negative logarithms, so
// that nothing large is subtracted. Its sixth root goes with each step: at grazing angles the steps alone would
// overflow.
float smithG2Beta(float lambdaI, float lambdaO) {
  float x = 7.0 + lambdaI;
  float y = 7.0 + lambdaO;
  float power = x * log1pPositive(y / x) + y * log1pPositive(x / y);
  float rest = stirlingRest(x) + stirlingRest(y) - stirlingRest(x + y);
  float root = exp(-power / 6.0);
  float product = sqrt(2.0 * BSDF_PI * (1.0 / x + 1.0 / y)) * exp(rest);
  for (int k = 0; k < 6; ++k) {
    x -= 1.0;
    y -= 1.0;
    product *= ((x + y) / x * root) * ((x + y + 1.0) / y);
  }
  return min(product, 1.0);
}

float ggxG2Beta(Tilt wi, Tilt wo, float alpha) {
  return smithG2Beta(ggxLambda(wi, alpha), ggxLambda(wo, alpha));
}

float ggxVBeta(Tilt wi, Tilt wo, float alpha) {
  float cosines = 4.0 * wi.z * wo.z;
  return cosines > 0.0 ? ggxG2Beta(wi, wo, alpha) / cosines : 0.0;
}

#endif
