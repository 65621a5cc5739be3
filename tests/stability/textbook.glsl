// textbook.glsl: the same model in the formulas that engines usually carry, as a measure of what the care in shaders/bsdf
// buys. Each line is right on paper; what float32 makes of it is the question.
#include "bsdf/values.glsl"

float textbookD(int distribution, float alpha, float nDotH) {
  float a2 = alpha * alpha;
  float c2 = nDotH * nDotH;
  if (distribution == BSDF_GGX) {
    float d = c2 * (a2 - 1.0) + 1.0;
    return a2 / (BSDF_PI * d * d);
  }
  if (distribution == BSDF_BECKMANN)
    return exp(-(1.0 - c2) / (c2 * a2)) / (BSDF_PI * a2 * c2 * c2);
  return (alpha + 2.0) / (2.0 * BSDF_PI) * pow(nDotH, alpha);
}

float textbookG1(int distribution, float alpha, float nDotV) {
  float a2 = alpha * alpha;
  if (distribution == BSDF_GGX)
    return 2.0 * nDotV / (nDotV + sqrt(a2 + (1.0 - a2) * nDotV * nDotV));
  float cotangent = nDotV / sqrt(1.0 - nDotV * nDotV);
  float a = distribution == BSDF_PHONG ? sqrt(0.5 * alpha + 1.0) * cotangent : cotangent / alpha;
  return a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a) : 1.0;
}

// Walter's eq. 22 with c = |i . h|.
float textbookDielectric(float eta, float c) {
  float radicand = eta * eta - 1.0 + c * c;
  if (radicand < 0.0) return 1.0;
  float g = sqrt(radicand);
  float s = (g - c) / (g + c);
  float p = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return 0.5 * s * s * (1.0 + p * p);
}

float textbookConductor(float n, float k, float c) {
  float c2 = c * c;
  float s2 = 1.0 - c2;
  float t0 = n * n - k * k - s2;
  float r = sqrt(t0 * t0 + 4.0 * n * n * k * k);
  float a = sqrt(0.5 * (r + t0));
  float rs = (r + c2 - 2.0 * a * c) / (r + c2 + 2.0 * a * c);
  float t3 = c2 * r + s2 * s2;
  float t4 = 2.0 * a * c * s2;
  return 0.5 * rs * (1.0 + (t3 - t4) / (t3 + t4));
}

// i is the known direction, as in Walter's paper.
BsdfValues textbookValues(vec3 i, vec3 o, vec3 n, BsdfSurface surface) {
  BsdfValues v = bsdfNoValues();
  float iDotN = dot(i, n);
  float oDotN = dot(o, n);
  vec3 h = normalize(surface.transmits ? i + surface.eta * o : i + o);
  if (dot(h, n) < 0.0) h = -h;
  float nDotH = dot(n, h);
  float iDotH = dot(i, h);
  float oDotH = dot(o, h);
  bool sides = surface.transmits ? iDotN * oDotN < 0.0 : iDotN * oDotN > 0.0;
  if (!sides || iDotH * iDotN <= 0.0 || oDotH * oDotN <= 0.0) return v;

  v.d = textbookD(surface.distribution, surface.alpha, nDotH);
  float gi = textbookG1(surface.distribution, surface.alpha, abs(iDotN));
  float go = textbookG1(surface.distribution, surface.alpha, abs(oDotN));
  v.g = gi * go;
  v.gCorrelated = surface.distribution == BSDF_GGX ? 1.0 / (1.0 / gi + 1.0 / go - 1.0) : 0.0;
  v.fresnel = surface.eta == 0.0 ? textbookConductor(surface.n, surface.k, abs(iDotH))
                                 : textbookDielectric(surface.eta, abs(iDotH));
  v.transmitted = 1.0 - v.fresnel;
  float jacobian = 0.25 / abs(oDotH);
  float perG = v.fresnel * v.d / (4.0 * abs(iDotN) * abs(oDotN));
  if (surface.transmits) {
    float denominator = iDotH + surface.eta * oDotH;
    jacobian = surface.eta * surface.eta * abs(oDotH) / (denominator * denominator);
    perG = abs(iDotH) / (abs(iDotN) * abs(oDotN)) * jacobian * v.transmitted * v.d;
  }
  v.f = perG * v.g;
  v.fCos = v.f * abs(oDotN);
  v.fCorrelated = perG * v.gCorrelated;
  v.pdfD = v.d * nDotH * jacobian;
  v.pdfVisible = surface.distribution == BSDF_GGX ? gi * abs(iDotH) * v.d / abs(iDotN) * jacobian : 0.0;
  return v;
}
