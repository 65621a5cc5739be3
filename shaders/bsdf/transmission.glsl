// transmission.glsl: the rough refraction lobe f_t, ideal refraction, and the densities of refracted directions.
// Frame    any: wi, wo unit and away from the surface, on its two sides; n through Facet (half_vector.glsl).
// alpha    through d and v: D at facet.h and V at (facet.wi, facet.wo), of any one distribution. eta = n_wi / n_wo.
// Returns  transmissionScatter: f_t for power, 1/sr, its integral with |wi.n| over wi is T(wo); transmissionF: f_t for
//          radiance seen along wo; transmissionFCos: that times |wi . n|. transmissionPdf: 1/sr.
//          refractAbout: unit wi, or vec3(0) past the critical angle. All 0 where no facet exists.
// Source   [Walter07] eq. 21 (f_t), 17 (Jacobian), 40 (ideal refraction); [Veach97] 5.2 (radiance against power).
// Limits   single scattering. Smooth (alpha = 0) or index-matched (eta = 1) surfaces transmit a delta: its finite
//          part, 0, is what f and pdf return, and the whole of it is refractAbout(wo, n) weighted by 1 - F (1 at eta
//          = 1).
#ifndef GG_BSDF_TRANSMISSION_GLSL
#define GG_BSDF_TRANSMISSION_GLSL

#include "bsdf/fresnel_dielectric.glsl"
#include "bsdf/half_vector.glsl"

// Walter's f_t(i, o) with i := wo, o := wi, so that its eta_o² / (eta_i i.m + eta_o o.m)² reads eta² / |h|².
float transmissionScatter(Facet f, float d, float v, float eta) {
  if (!(f.exists && d > 0.0)) return 0.0; // D = 0 with an infinite V, as in reflectionLobe
  float through = fresnelTransmitted(f.woDotM, f.g, eta);
  return 4.0 * eta * f.wiDotM * v * (eta * f.woDotM / f.s * d) * through;
}

// Refraction squeezes a lobe's solid angle, so radiance is not conserved across an interface; radiance / n² is. Power
// that leaves wo with T(wo) arrives from wi's medium as radiance L, and is seen as T L / eta². This is the only place
// where that factor enters; it cancels on the way out of a solid, and stays for an eye inside the glass.
float transmissionF(Facet f, float d, float v, float eta) {
  float scatter = transmissionScatter(f, d, v, eta);
  return f.exists ? scatter / (eta * eta) : 0.0;
}

float transmissionFCos(Facet f, float d, float v, float eta) {
  return transmissionF(f, d, v, eta) * f.wi.z;
}

// Density of wi for a known wo, when wm has density pdfM.
float transmissionPdf(Facet f, float pdfM, float eta) { return pdfM * transmissionJacobian(f, eta); }

// Snell's law about the facet wm, which may point to either side: wi = ((c - g) wm - wo) / eta. With
// c - g = (1 - eta²) / (c + g) the direction goes over into -wo without a step as eta -> 1.
vec3 refractAbout(vec3 wo, vec3 wm, float eta) {
  float side = dot(wo, wm) < 0.0 ? -1.0 : 1.0;
  float c = abs(dot(wo, wm));
  float g = fresnelG(c, eta);
  if (eta == 1.0) return -wo;
  if (!(g > 0.0 && eta > 0.0)) return vec3(0.0);
  float along = (1.0 - eta) * (1.0 + eta) / (c + g);
  return ((side * along) * wm - wo) / eta;
}

#endif
