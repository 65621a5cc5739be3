// thin_wall_table.glsl: two equal rough interfaces at no distance (a soap film, a pane): where their tables are read.
// Frame    any: n, wo unit, n on wo's side. Angles as in interface_table.glsl: from -n towards the side opposite wo.
// alpha    slope width of both faces in [0, 1] (clamped). eta: the wall's index over its surroundings', [1, 4]; below 1 the
//          same wall is read as its reciprocal. sigma: radians per axis.
// Returns  thinWall...Coordinate: texture coordinates in [0, 1]. thinWallWidth: the lobe's width to first order, radians.
//          thinWallEnergy: shares of the light, all orders of reflection inside. thinWallLobe: one of the Gaussians of what gets
//          through; its direction by interfaceLobeDirection. thinWallLaterSpread: of what comes back from within, over the width
//          of what the first face reflects.
// Source   made by `groundglass tables` (app/tables): paths through both faces, [Walter07] at each.
// Limits   single scattering at each face; light inside meets the other face at a place of its own, so no interference and
//          no shift. Below 1 there is total reflection outside, which the reciprocal index does not have.
#ifndef GG_REFRACTION_THIN_WALL_TABLE_GLSL
#define GG_REFRACTION_THIN_WALL_TABLE_GLSL

#include "bsdf/constants.glsl"
#include "refraction/interface_table.glsl"

const int THIN_WALL_COSINES = 25;
const int THIN_WALL_ALPHAS = 16;
const int THIN_WALL_SLICES = 13;

vec3 thinWallCoordinate(int lobe, int lobes, float cosTheta, float alpha, float eta) {
  return vec3(tableCoordinate(sqrt(max(cosTheta, 0.0)), THIN_WALL_COSINES),
              blockCoordinate(sqrt(max(alpha, 0.0)), THIN_WALL_ALPHAS, lobe, lobes),
              tableCoordinate(interfaceEtaAxis(eta), THIN_WALL_SLICES));
}

// Each face turns the ray by |eta cos_t - cos_i| alpha, on its own; 1 / cos_i of that within the plane of incidence. Cut off
// as interfaceWidth is.
float thinWallWidth(float cosTheta, float alpha, float eta) {
  float c = clamp(cosTheta, 0.0, 1.0);
  float n = eta < 1.0 ? 1.0 / max(eta, 0.01) : eta;
  float across = (n - 1.0) * (n + 1.0) / max(fresnelG(c, n) + c, LEAST_DIVISOR);
  float width = 1.41421356 * alpha * across * inversesqrt(sqrt(c * c + max(alpha, LEAST_LENGTH2)));
  return width / (1.0 + 2.0 * width);
}

struct ThinWallEnergy {
  float transmitted;
  float reflectedFirst; // by the face that the light meets first
  float reflectedLater; // what comes back through it
};

ThinWallEnergy thinWallEnergy(vec4 texel) {
  ThinWallEnergy e;
  e.transmitted = texel.x;
  e.reflectedFirst = texel.y;
  e.reflectedLater = texel.z;
  return e;
}

// At normal incidence and to first order: a facet's tilt t turns what the first face reflects by 2 t; the far face's turns what it
// reflects by 2 t inside, n times that outside, and both passages of the near one by (n - 1) t each, at facets of their own.
float thinWallLaterSpread(float eta) {
  float n = eta < 1.0 ? 1.0 / max(eta, 0.01) : eta;
  return sqrt(n * n + 0.5 * (n - 1.0) * (n - 1.0));
}

// What is not scattered goes straight on.
InterfaceLobe thinWallLobe(vec4 texel, float cosTheta, float alpha, float eta) {
  float c = clamp(cosTheta, 0.0, 1.0);
  float width = thinWallWidth(c, clamp(alpha, 0.0, 1.0), eta);
  InterfaceLobe lobe;
  lobe.angle = atan(sqrt((1.0 - c) * (1.0 + c)), c) + texel.x * width;
  lobe.sigma = texel.y * width;
  lobe.weight = texel.z;
  return lobe;
}

#endif
