// proxy_lobe.glsl: what a neighbour reflects, as one Gaussian lobe in closed form: GGX without tables.
// Frame    any; wo, n unit.
// alpha    slope width of D in [0, 1].
// Returns  proxyLobe: the lobe's mean direction, its sigma in radians, and the albedo for F = 1. proxyFresnel: Schlick's mean over
//          the lobe, from the reflectance at normal incidence and at 90 degrees; in [0, 1].
// Source   fitted to the one-lobe table of metals (assets/tables/reflection-lobes1-ggx-separable.exr and -energy-).
// Limits   sigma within 40 % (17 % rms), albedo within .06 (.022 rms) for alpha from .02 to 1 and cosines from .2 to 1
//          (tests/neighbours); one lobe for every Fresnel curve: what a dielectric's edge adds is not apart.
#ifndef GG_NEIGHBOURS_PROXY_LOBE_GLSL
#define GG_NEIGHBOURS_PROXY_LOBE_GLSL

struct ProxyLobe {
  vec3 direction;
  float sigma;
  float albedo;
};

ProxyLobe proxyLobe(vec3 wo, vec3 n, float alpha) {
  float c = clamp(dot(wo, n), 0.0, 1.0);
  vec3 mirror = 2.0 * dot(wo, n) * n - wo;
  ProxyLobe lobe;
  // From the mirror direction towards the normal: all facets of alpha 1 are alike.
  lobe.direction = normalize(mix(mirror, n, alpha * (1.0 + (1.0 - c) * (1.0 - alpha))));
  float narrow = 1.9 * alpha;
  lobe.sigma = narrow * inversesqrt(1.0 + narrow * narrow / 0.5476); // .74: the hemisphere's own width
  float normal = 1.0 / (1.0 + 2.26 * pow(alpha, 2.3));
  float grazing = 0.9 - 0.34 * alpha;
  float square = (1.0 - alpha) * (1.0 - alpha);
  float edge = alpha > 0.0 ? pow(1.0 - c, 1.5 + 4.0 * square * square) : 0.0;
  lobe.albedo = mix(normal, grazing, edge);
  return lobe;
}

vec3 proxyFresnel(vec3 f0, float f90, float cosTheta, float alpha) {
  float c = mix(clamp(cosTheta, 0.0, 1.0), 0.65, sqrt(alpha)); // the facets' mean
  float x = 1.0 - c;
  float x2 = x * x;
  return f0 + (vec3(f90) - f0) * (x2 * x2 * x);
}

#endif
