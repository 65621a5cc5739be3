// wandering.glsl: light that has lost its way inside a solid, and comes to its faces from all sides alike: what gets out of it.
// Frame    none. ior = n_inside / n_outside > 0.
// alpha    slope width of the faces, [0, 1].
// Returns  wanderingPasses: of isotropic light that comes to a smooth face from inside, the share that passes, (0, 1].
//          wanderingEscapes: of light that comes to rough faces again and again, the share that is out in the end, (0, 1];
//          single scattering loses the rest, smooth faces nothing. wanderingLossGgx, wanderingLossBeckmann: its constants.
//          wanderingLeaves: the share that is out for good, where of what gets out the share `again` < 1 meets the body again.
// Source   reciprocity: n² times as much passes into the denser side as out of it. Losses are fits to the tables of energy.
// Limits   escapes at ior 1.1 to 2.6 within .02 (GGX), .035 (Beckmann; .16 for Phong's tables) of what the tables of separable
//          Smith integrate to, .06 of correlated GGX's (tests/composition); no absorption. Below ior 1 losses are overestimated.
#ifndef GG_REFRACTION_WANDERING_GLSL
#define GG_REFRACTION_WANDERING_GLSL

#include "bsdf/fresnel_dielectric.glsl"

// Lost at each face: alpha² / (alpha² + linear alpha + constant), less by thin alpha where more passes than from glass; of
// what a smooth face passes a rough one passes 1 - passes alpha².
struct WanderingLoss {
  float linear;
  float constant;
  float thin;
  float passes;
};

WanderingLoss wanderingLossGgx() {
  WanderingLoss k;
  k.linear = 0.635;
  k.constant = 0.254;
  k.thin = 1.078;
  k.passes = 0.3;
  return k;
}

WanderingLoss wanderingLossBeckmann() {
  WanderingLoss k;
  k.linear = 0.201;
  k.constant = 1.555;
  k.thin = 0.565;
  k.passes = 0.0;
  return k;
}

// 2 int (1 - F) c dc from the thinner side, where nothing is past a critical angle: Gauss-Jacobi with two nodes.
float wanderingPasses(float ior) {
  float eta = max(ior, 1.0 / ior);
  float passes = 0.363917 * fresnelTransmittedAt(0.355051, eta) + 0.636083 * fresnelTransmittedAt(0.844949, eta);
  return ior > 1.0 ? passes / (ior * ior) : passes;
}

float wanderingEscapes(float alpha, float ior, WanderingLoss k) {
  float smoothly = wanderingPasses(ior);
  float alpha2 = alpha * alpha;
  float lost = alpha2 / (alpha2 + k.linear * alpha + k.constant) * max(1.0 - k.thin * alpha * max(smoothly - 0.4, 0.0), 0.0);
  float passes = smoothly * (1.0 - k.passes * alpha2);
  return passes / (passes + lost);
}

float wanderingLeaves(float escapes, float again) { return escapes * (1.0 - again) / (1.0 - escapes * again); }

#endif
