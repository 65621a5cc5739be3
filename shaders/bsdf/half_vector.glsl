// half_vector.glsl: the microfacet that joins two directions, by reflection or by refraction.
// Frame    any: n is the unit normal, vec3(0, 0, 1) in the local frame; wo, wi unit and away from the surface.
// alpha    none. eta = n_far / n_known, far = wi's side, known = wo's side; 0 stands for a metal.
// Returns  tilt, tiltAbout: sin² and cos of a vector against n, on the vector's own scale; tiltCos: in [0, 1].
//          reflectionHalf, transmissionHalf: the half-vector, not normalised, sign as it falls.
//          reflectionFacet, transmissionFacet: everything that D, G, F, f and the pdfs read, as one struct.
//          reflectionJacobian, transmissionJacobian: dω_m / dω_i for a known wo, >= 0, dimensionless.
// Source   [Walter07] eq. 13, 14 (reflection), 16, 17 (refraction).
// Limits   loses digits as the input itself does: h is as exact as the rounded sum wi + eta wo; where wi and wo
//          nearly cancel (grazing mirror, straight-through) compensated.glsl keeps five digits. Directions on
//          impossible sides, on the horizon, eta = 1 in transmission and wi = -wo give exists = false, with every
//          number finite.
#ifndef GG_BSDF_HALF_VECTOR_GLSL
#define GG_BSDF_HALF_VECTOR_GLSL

// A vector v against the normal: p = |v x n|² and z = |v . n|. All that D, Lambda and G1 ask of a direction is
// tan² = p / z², so v need not be unit, and nothing is lost near the normal, where 1 - cos² keeps no digits at all.
struct Tilt {
  float p;
  float z;
};

// In the local frame, n = +z.
Tilt tilt(vec3 v) {
  Tilt t;
  t.p = v.x * v.x + v.y * v.y;
  t.z = abs(v.z);
  return t;
}

// Against any unit normal n.
Tilt tiltAbout(vec3 v, vec3 n) {
  vec3 across = cross(v, n);
  Tilt t;
  t.p = dot(across, across);
  t.z = abs(dot(v, n));
  return t;
}

// Cosine of the angle between the vector and the normal; 0 for the zero vector.
float tiltCos(Tilt t) {
  float s = t.p + t.z * t.z;
  return s > 0.0 ? t.z / sqrt(s) : 0.0;
}

struct Facet {
  Tilt wi;      // of wi
  Tilt wo;      // of wo
  Tilt h;       // of the half-vector h, not normalised
  float s;      // |h|²
  float wiDotM; // |wi . wm|, wm = h / |h|
  float woDotM; // |wo . wm|
  float g;      // Fresnel's sqrt(eta² - sin²) = eta cos of the far side; 0 past the critical angle
  bool exists;  // false: no facet joins wi and wo this way, and every f and pdf is 0
};

// Half-vectors, not normalised. Refraction's is wo + eta wi, written so that both steps are exact where they cancel (wi
// near -wo, eta near 1); rounding the product first is 100 times worse.
vec3 reflectionHalf(vec3 wi, vec3 wo) { return wi + wo; }
vec3 transmissionHalf(vec3 wi, vec3 wo, float eta) { return (wi + wo) + (eta - 1.0) * wi; }

// The facet that mirrors wo into wi. |h| = 2 cos of the angle of incidence, so the cosine comes from a sum
// of squares; dot(wi, h) would subtract nearly equal products at a grazing forward mirror (11 % off in float32). And
// g² = (eta² - 1) + cos² keeps its digits as eta -> 1, where eta² - sin² does not.
Facet reflectionFacet(vec3 wi, vec3 wo, vec3 n, float eta) {
  vec3 h = reflectionHalf(wi, wo);
  float cosI = dot(wi, n);
  float cosO = dot(wo, n);
  Facet f;
  f.wi = tiltAbout(wi, n);
  f.wo = tiltAbout(wo, n);
  f.h = tiltAbout(h, n);
  f.s = dot(h, h);
  f.woDotM = min(0.5 * sqrt(f.s), 1.0);
  f.wiDotM = f.woDotM;
  f.g = sqrt(max((eta - 1.0) * (eta + 1.0) + f.woDotM * f.woDotM, 0.0));
  f.exists = ((cosI > 0.0 && cosO > 0.0) || (cosI < 0.0 && cosO < 0.0)) && f.h.z > 0.0;
  return f;
}

// The facet that refracts wo into wi, its half-vector turned to wo's side. |h|² equals Walter's denominator
// (wo . wm + eta wi . wm)² without its cancellation.
Facet transmissionFacet(vec3 wi, vec3 wo, vec3 n, float eta) {
  vec3 h = transmissionHalf(wi, wo, eta);
  float cosI = dot(wi, n);
  float cosO = dot(wo, n);
  float side = dot(h, n) * cosO < 0.0 ? -1.0 : 1.0;
  Facet f;
  f.wi = tiltAbout(wi, n);
  f.wo = tiltAbout(wo, n);
  f.h = tiltAbout(h, n);
  f.s = dot(h, h);
  float hDotI = side * dot(h, wi);
  float hDotO = side * dot(h, wo);
  bool possible = ((cosI > 0.0 && cosO < 0.0) || (cosI < 0.0 && cosO > 0.0)) && eta > 0.0 && eta != 1.0;
  f.exists = possible && f.h.z > 0.0 && hDotI < 0.0 && hDotO > 0.0;
  float scale = f.exists ? inversesqrt(f.s) : 0.0;
  f.wiDotM = min(abs(hDotI) * scale, 1.0);
  f.woDotM = min(abs(hDotO) * scale, 1.0);
  f.g = eta * f.wiDotM;
  return f;
}

float reflectionJacobian(Facet f) { return f.exists ? 0.25 / f.woDotM : 0.0; }

float transmissionJacobian(Facet f, float eta) {
  return f.exists ? eta * eta * f.wiDotM / f.s : 0.0;
}

#endif
