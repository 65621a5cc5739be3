// internal_scattering.glsl: diffuse internal scattering: light inside a solid that comes to its faces from all sides alike, and
// what of it gets out.
// Frame    none. ior = n_inside / n_outside > 0.
// alpha    slope width of the faces, [0, 1].
// Returns  internalScatteringPasses: of isotropic light that comes to a smooth face from inside, the share that passes, (0, 1].
//          internalScatteringAt: what becomes of it at a rough face; single scattering loses the rest, smooth faces lose nothing.
//          internalScatteringLossGgx, ...LossBeckmann: its constants. internalScatteringConcave: the same, where of what passes
//          the share `again`, below 1, meets the body once more. internalScatteringEscapes: of light that sets out from a face,
//          the share that is out in the end, where absorption leaves `way`, [0, 1], of it from face to face.
// Source   reciprocity: n² times as much passes into the denser side as out of it. Losses are fits to the tables of energy.
// Limits   internalScatteringEscapes without absorption, ior 1.1 to 2.6: within .02 (GGX), .045 (Beckmann; .1 for Phong's
//          tables) of what separable Smith's tables integrate to, .06 of correlated GGX's (tests/composition). Below ior 1 it
//          loses too much.
#ifndef GG_REFRACTION_INTERNAL_SCATTERING_GLSL
#define GG_REFRACTION_INTERNAL_SCATTERING_GLSL

#include "bsdf/fresnel_dielectric.glsl"

struct InternalScattering {
  float passes;
  float back; // is reflected inside
};

// Lost at each face: alpha² / (alpha² + linear alpha + constant), less by thin alpha where more passes than from glass; of
// what a smooth face passes a rough one passes 1 - passes alpha².
struct InternalScatteringLoss {
  float linear;
  float constant;
  float thin;
  float passes;
};

InternalScatteringLoss internalScatteringLossGgx() {
  InternalScatteringLoss k;
  k.linear = 0.635;
  k.constant = 0.254;
  k.thin = 1.078;
  k.passes = 0.3;
  return k;
}

InternalScatteringLoss internalScatteringLossBeckmann() {
  InternalScatteringLoss k;
  k.linear = 0.201;
  k.constant = 1.555;
  k.thin = 0.565;
  k.passes = 0.0;
  return k;
}

// 2 int (1 - F) c dc from the thinner side, where nothing is past a critical angle: Gauss-Jacobi with two nodes.
float internalScatteringPasses(float ior) {
  float eta = max(ior, 1.0 / ior);
  float passes = 0.363917 * fresnelTransmittedAt(0.355051, eta) + 0.636083 * fresnelTransmittedAt(0.844949, eta);
  return ior > 1.0 ? passes / (ior * ior) : passes;
}

InternalScattering internalScatteringAt(float alpha, float ior, InternalScatteringLoss k) {
  float smoothly = internalScatteringPasses(ior);
  float alpha2 = alpha * alpha;
  float lost = alpha2 / (alpha2 + k.linear * alpha + k.constant) * max(1.0 - k.thin * alpha * max(smoothly - 0.4, 0.0), 0.0);
  InternalScattering w;
  w.passes = smoothly * (1.0 - k.passes * alpha2);
  w.back = max(1.0 - w.passes - lost, 0.0);
  return w;
}

InternalScattering internalScatteringConcave(InternalScattering w, float again) {
  InternalScattering concave;
  concave.passes = (1.0 - again) * w.passes;
  concave.back = w.back + again * w.passes;
  return concave;
}

// A geometric series: way passes (1 + way back + (way back)² + ...).
vec3 internalScatteringEscapes(InternalScattering w, vec3 way) {
  return w.passes * way / max(vec3(1.0) - w.back * way, vec3(w.passes));
}

#endif
