// values.glsl: every quantity of the microfacet model for one pair of directions, side by side, to study and to test.
// Frame    through Facet (half_vector.glsl): wo is the known direction (Walter's i), wi the other (Walter's o).
// alpha    slope width >= 0; for Phong its exponent. eta = n_far / n_known; 0 is a metal of complex index n + i k.
// Returns  bsdfValues: D, G separable, G2 = 1 / (1 + Lambda_i + Lambda_o) (GGX, else 0), F and 1 - F, Walter's f_r or
//          f_t with G and with G2 (1/sr), f_cos = f |wi . n|, and the pdfs of wi (1/sr) when wm is drawn from D |wm .
//          n| and from the visible normals (GGX, else 0), Fresnel's choice left out. All of them 0 where no facet
//          exists.
// Source   [Walter07] eq. 14, 17, 20, 21; the snippets that are included name the rest.
// Limits   f_t is for power, Walter's eta_o² in it. G2 in transmission is the often-used form, too large:
//          smith_beta.glsl.
#ifndef GG_BSDF_VALUES_GLSL
#define GG_BSDF_VALUES_GLSL

#include "bsdf/beckmann.glsl"
#include "bsdf/compensated.glsl"
#include "bsdf/fresnel_conductor.glsl"
#include "bsdf/ggx.glsl"
#include "bsdf/half_vector.glsl"
#include "bsdf/phong.glsl"
#include "bsdf/reflection.glsl"
#include "bsdf/transmission.glsl"

const int BSDF_GGX = 0;
const int BSDF_BECKMANN = 1;
const int BSDF_PHONG = 2;

struct BsdfSurface {
  bool transmits;   // which lobe is asked for
  int distribution; // BSDF_...
  float alpha;
  float eta;
  float n;
  float k;
};

struct BsdfValues {
  float d;
  float g;
  float gCorrelated;
  float fresnel;
  float transmitted; // 1 - F
  float f;
  float fCos;
  float fCorrelated;
  float pdfD;
  float pdfVisible;
};

BsdfValues bsdfNoValues() {
  BsdfValues r;
  r.d = 0.0;
  r.g = 0.0;
  r.gCorrelated = 0.0;
  r.fresnel = 0.0;
  r.transmitted = 0.0;
  r.f = 0.0;
  r.fCos = 0.0;
  r.fCorrelated = 0.0;
  r.pdfD = 0.0;
  r.pdfVisible = 0.0;
  return r;
}

// D, G and V of the distribution that is asked for, and V with the correlated G2.
struct BsdfShape {
  float d;
  float g;
  float v;
  float vCorrelated;
};

BsdfShape bsdfShape(Facet f, int distribution, float alpha) {
  BsdfShape r;
  r.vCorrelated = 0.0;
  if (distribution == BSDF_GGX) {
    r.d = ggxD(f.h, alpha);
    r.g = ggxG2(f.wi, f.wo, alpha);
    r.v = ggxV(f.wi, f.wo, alpha);
    r.vCorrelated = ggxVCorrelated(f.wi, f.wo, alpha);
  } else if (distribution == BSDF_BECKMANN) {
    r.d = beckmannD(f.h, alpha);
    r.g = beckmannG2(f.wi, f.wo, alpha);
    r.v = beckmannV(f.wi, f.wo, alpha);
  } else {
    r.d = phongD(f.h, alpha);
    r.g = phongG2(f.wi, f.wo, alpha);
    r.v = phongV(f.wi, f.wo, alpha);
  }
  return r;
}

BsdfValues bsdfValues(Facet f, BsdfSurface surface) {
  BsdfValues r = bsdfNoValues();
  if (!f.exists) return r;
  BsdfShape shape = bsdfShape(f, surface.distribution, surface.alpha);
  bool ggx = surface.distribution == BSDF_GGX;
  bool metal = surface.eta == 0.0;
  float pdfM = shape.d * tiltCos(f.h);
  float pdfVisibleM = ggx ? ggxPdfVisible(f, surface.alpha) : 0.0;
  r.d = shape.d;
  r.g = shape.g;
  r.gCorrelated = ggx ? ggxG2Correlated(f.wi, f.wo, surface.alpha) : 0.0;
  r.fresnel = metal ? fresnelConductor(f.woDotM, surface.n, surface.k)
                    : fresnelDielectric(f.woDotM, f.g, surface.eta);
  r.transmitted = metal ? fresnelAbsorbed(f.woDotM, surface.n, surface.k)
                        : fresnelTransmitted(f.woDotM, f.g, surface.eta);
  if (surface.transmits) {
    r.f = transmissionScatter(f, shape.d, shape.v, surface.eta);
    r.fCorrelated = transmissionScatter(f, shape.d, shape.vCorrelated, surface.eta);
    r.pdfD = transmissionPdf(f, pdfM, surface.eta);
    r.pdfVisible = transmissionPdf(f, pdfVisibleM, surface.eta);
  } else {
    r.f = reflectionLobe(f, shape.d, shape.v * r.fresnel);
    r.fCorrelated = reflectionLobe(f, shape.d, shape.vCorrelated * r.fresnel);
    r.pdfD = reflectionPdf(f, pdfM);
    r.pdfVisible = reflectionPdf(f, pdfVisibleM);
  }
  r.fCos = r.f * f.wi.z;
  return r;
}

// The facet of the lobe that is asked for.
Facet bsdfFacet(vec3 wi, vec3 wo, vec3 n, BsdfSurface surface) {
  if (surface.transmits) return transmissionFacet(wi, wo, n, surface.eta);
  return reflectionFacet(wi, wo, n, surface.eta);
}

// The same with the rounding of its sums carried along (compensated.glsl).
Facet bsdfFacetCompensated(vec3 wi, vec3 wo, vec3 n, BsdfSurface surface) {
  if (surface.transmits) return preciseTransmissionFacet(wi, wo, n, surface.eta);
  return preciseReflectionFacet(wi, wo, n, surface.eta);
}

#endif
