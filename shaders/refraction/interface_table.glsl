// interface_table.glsl: where the tables of one rough interface are read, and what is made of what they hold.
// Frame    any: n, wo unit, n on wo's side. Angles in the plane of wo and n, from -n towards the side opposite wo, radians.
// alpha    slope width in [0, 1] (clamped). eta = n_far / n_near, far = beyond the interface, near = wo's side: above 1
//          entering, below 1 leaving; [1/4, 4] (clamped). sigma: radians per axis.
// Returns  interface...Coordinate: texture coordinates in [0, 1] that never mix blocks. interfaceSnell: angle of ideal
//          refraction, pi/2 past the critical angle. interfaceWidth: the lobe's width to first order, radians, the unit of
//          what the table holds. interfaceEnergy: shares of the light, [0, 1] each, their sum at most 1; transmitted
//          is power, without the 1 / eta² of radiance (transmission.glsl). interfaceLobe: one of the lobe's Gaussians.
//          interfaceLobeDirection: unit.
// Source   made by `groundglass tables` (app/tables) from the exact integrals over [Walter07] eq. 20, 21.
// Limits   single scattering. eta exactly 1 reads the limit from above: what facets block is still missing, though
//          nothing is bent. Callers draw index 1 by not drawing it.
#ifndef GG_REFRACTION_INTERFACE_TABLE_GLSL
#define GG_REFRACTION_INTERFACE_TABLE_GLSL

#include "bsdf/constants.glsl"
#include "bsdf/fresnel_dielectric.glsl"
#include "environment/table_axis.glsl"

// Texels along cos (odd, so that the critical angle is a node), along alpha, along eta on either side.
const int INTERFACE_ENERGY_COSINES = 65;
const int INTERFACE_ENERGY_ALPHAS = 32;
const int INTERFACE_LOBE_COSINES = 25;
const int INTERFACE_LOBE_ALPHAS = 16;
const int INTERFACE_SLICES = 13;
const float INTERFACE_GREATEST_ETA = 4.0;

struct InterfaceEnergy {
  float transmitted;
  float reflected;
};

struct InterfaceLobe {
  float angle;
  float sigma;
  float weight; // of K lobes they sum to 1; lobe 0 is the core, the narrowest
};

// Square roots crowd the nodes where lobes change within a facet's lean: along the surface, and leaving on either side of the
// critical angle, where half of the axis ends and past which another half goes back to the surface.
float interfaceCosineAxis(float cosTheta, float eta) {
  float c = clamp(cosTheta, 0.0, 1.0);
  if (eta >= 1.0) return sqrt(c);
  float critical = sqrt((1.0 - eta) * (1.0 + eta));
  bool past = c < critical;
  float along = past ? c / critical : (c - critical) / (1.0 - critical);
  bool grazing = past && along < 0.5;
  float x = sqrt(past ? 0.125 * (grazing ? along : 1.0 - along) : 0.25 * along);
  return grazing ? x : past ? 0.5 - x : 0.5 + x;
}

// Its inverse: the cosine at x in [0, 1].
float interfaceCosineAt(float x, float eta) {
  if (eta >= 1.0) return x * x;
  float critical = sqrt((1.0 - eta) * (1.0 + eta));
  float away = x - 0.5;
  if (away >= 0.0) return critical + 4.0 * away * away * (1.0 - critical);
  return critical * (x < 0.25 ? 8.0 * x * x : 1.0 - 8.0 * away * away);
}

// (n - 1) / (n + 1), n the larger index over the smaller, as a share of its value at the greatest.
float interfaceEtaAxis(float eta) {
  float n = clamp(eta < 1.0 ? 1.0 / max(eta, 0.01) : eta, 1.0, INTERFACE_GREATEST_ETA);
  return (n - 1.0) / (n + 1.0) * ((INTERFACE_GREATEST_ETA + 1.0) / (INTERFACE_GREATEST_ETA - 1.0));
}

// Entering lies before leaving.
vec3 interfaceEnergyCoordinate(float cosTheta, float alpha, float eta) {
  return vec3(blockCoordinate(interfaceCosineAxis(cosTheta, eta), INTERFACE_ENERGY_COSINES, 0, 1),
              blockCoordinate(sqrt(max(alpha, 0.0)), INTERFACE_ENERGY_ALPHAS, 0, 1),
              blockCoordinate(interfaceEtaAxis(eta), INTERFACE_SLICES, eta < 1.0 ? 1 : 0, 2));
}

vec3 interfaceLobeCoordinate(int lobe, int lobes, float cosTheta, float alpha, float eta) {
  return vec3(blockCoordinate(interfaceCosineAxis(cosTheta, eta), INTERFACE_LOBE_COSINES, 0, 1),
              blockCoordinate(sqrt(max(alpha, 0.0)), INTERFACE_LOBE_ALPHAS, lobe, lobes),
              blockCoordinate(interfaceEtaAxis(eta), INTERFACE_SLICES, eta < 1.0 ? 1 : 0, 2));
}

float interfaceSnell(float cosTheta, float eta) {
  float c = clamp(cosTheta, 0.0, 1.0);
  return atan(sqrt((1.0 - c) * (1.0 + c)), fresnelG(c, eta)); // tan = sin / g: eta cancels
}

// A facet that leans by t turns what it refracts by |cos_t - cos_i / eta| t across the plane of incidence and 1 / cos_t
// times that within it; the geometric mean of both. At the critical angle, where that grows beyond bounds, alpha bounds it:
// turned by that much, cos_t is no longer 0. Past it only facets that lean back as far let anything through, whatever
// alpha, and total reflection and the horizon cut wide lobes off at about a quarter of a radian.
// The difference of cosines is written without subtracting.
float interfaceWidth(float cosTheta, float alpha, float eta) {
  float g = fresnelG(clamp(cosTheta, 0.0, 1.0), eta);
  float critical = sqrt(max((1.0 - eta) * (1.0 + eta), 0.0));
  float across = abs((eta - 1.0) * (eta + 1.0)) / max(eta * (g + max(cosTheta, critical)), LEAST_DIVISOR);
  float cosT = g / eta;
  float lean = alpha + max(critical - cosTheta, 0.0);
  float width = lean * across * inversesqrt(sqrt(cosT * cosT + max(lean, LEAST_LENGTH2)));
  return width / (1.0 + 2.0 * width);
}

InterfaceEnergy interfaceEnergy(vec4 texel) {
  InterfaceEnergy e;
  e.transmitted = texel.x;
  e.reflected = texel.y;
  return e;
}

InterfaceLobe interfaceLobe(vec4 texel, float cosTheta, float alpha, float eta) {
  float width = interfaceWidth(cosTheta, clamp(alpha, 0.0, 1.0), eta);
  InterfaceLobe lobe;
  lobe.angle = interfaceSnell(cosTheta, eta) + texel.x * width;
  lobe.sigma = texel.y * width;
  lobe.weight = texel.z;
  return lobe;
}

// At normal incidence no side is opposite wo: any will do, as the lobe is round.
vec3 interfaceLobeDirection(vec3 wo, vec3 n, float angle) {
  vec3 across = dot(wo, n) * n - wo;
  if (!(dot(across, across) > LEAST_LENGTH2)) across = cross(n, abs(n.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
  return sin(angle) * normalize(across) - cos(angle) * n;
}

#endif
