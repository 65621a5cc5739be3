// wandering.glsl: light that has lost its way inside a solid, and comes to its faces from all sides alike: what gets out of it.
// Frame    none. ior = n_inside / n_outside > 0.
// alpha    slope width of the faces, [0, 1].
// Returns  wanderingPasses: of isotropic light that comes to a smooth face from inside, the share that passes, (0, 1].
//          wanderingAt: what becomes of it at a rough face; single scattering loses the rest, smooth faces lose nothing.
//          wanderingLossGgx, wanderingLossBeckmann: its constants. wanderingConcave: the same, where of what passes the share
//          `again`, below 1, meets the body once more. wanderingEscapes: of light that sets out from a face, the share that is out
//          in the end, where absorption leaves `way`, [0, 1], of it from face to face.
// Source   reciprocity: n² times as much passes into the denser side as out of it. Losses are fits to the tables of energy.
// Limits   wanderingEscapes without absorption, ior 1.1 to 2.6: within .02 (GGX), .045 (Beckmann; .1 for Phong's tables) of what
//          separable Smith's tables integrate to, .06 of correlated GGX's (tests/composition). Below ior 1 it loses too much.
#ifndef GG_REFRACTION_WANDERING_GLSL
#define GG_REFRACTION_WANDERING_GLSL

#include "bsdf/fresnel_dielectric.glsl"

struct Wandering {
  float passes;
  float back; // is thrown back inside
};

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

Wandering wanderingAt(float alpha, float ior, WanderingLoss k) {
  float smoothly = wanderingPasses(ior);
  float alpha2 = alpha * alpha;
  float lost = alpha2 / (alpha2 + k.linear * alpha + k.constant) * max(1.0 - k.thin * alpha * max(smoothly - 0.4, 0.0), 0.0);
  Wandering w;
  w.passes = smoothly * (1.0 - k.passes * alpha2);
  w.back = max(1.0 - w.passes - lost, 0.0);
  return w;
}

Wandering wanderingConcave(Wandering w, float again) {
  Wandering concave;
  concave.passes = (1.0 - again) * w.passes;
  concave.back = w.back + again * w.passes;
  return concave;
}

// A geometric series: way passes (1 + way back + (way back)² + ...).
vec3 wanderingEscapes(Wandering w, vec3 way) { return w.passes * way / max(vec3(1.0) - w.back * way, vec3(w.passes)); }

#endif
