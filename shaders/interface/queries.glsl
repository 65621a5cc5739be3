// queries.glsl: how questions to the BSDF and their answers lie in storage buffers (std430), in GLSL and in C++.
// The host packs them in app/bsdf; shaders/stages/eval.comp answers them.
#ifndef GG_INTERFACE_QUERIES_GLSL
#define GG_INTERFACE_QUERIES_GLSL

struct PackedQuery {
  vec4 iAlpha; // i, alpha
  vec4 oEta;   // o, eta
  vec4 nIndex; // n, real part of a metal's index
  vec4 rest;   // imaginary part of it; lobe (0 R, 1 T); distribution (0 GGX, 1 Beckmann, 2 Phong); unused
};

struct PackedValues {
  vec4 first;  // D, G, G2, F
  vec4 second; // 1 - F, f, f_cos, f_G2
  vec4 third;  // pdf_D, pdf_vndf, unused, unused
};

#endif
