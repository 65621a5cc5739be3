#version 450
// The values of a batch of queries in one of three ways of writing the same model, or f alone, many times, for the clock.
#include "interface/queries.glsl"
#include "textbook.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 0) const int way = 0; // 0 textbook, 1 stable, 2 compensated, 3 nothing (what the loop itself costs)
// Of the clock: how often, and for which lobe and distribution the code is made.
layout(constant_id = 1) const int repeats = 0;
layout(constant_id = 2) const bool transmits = false;
layout(constant_id = 3) const int distribution = 0;

layout(std430, set = 0, binding = 0) readonly buffer Queries { PackedQuery queries[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { PackedValues answers[]; };

BsdfValues valuesOf(vec3 i, vec3 o, vec3 n, BsdfSurface surface) {
  if (way == 0) return textbookValues(i, o, n, surface);
  if (way == 1) return bsdfValues(bsdfFacet(o, i, n, surface), surface);
  return bsdfValues(bsdfFacetCompensated(o, i, n, surface), surface);
}

void main() {
  uint row = gl_GlobalInvocationID.x;
  if (row >= uint(queries.length())) return;
  PackedQuery q = queries[row];
  BsdfSurface surface;
  surface.transmits = q.rest.y > 0.5;
  surface.distribution = int(q.rest.z);
  surface.alpha = q.iAlpha.w;
  surface.eta = q.oEta.w;
  surface.n = q.nIndex.w;
  surface.k = q.rest.x;
  vec3 i = q.iAlpha.xyz;
  vec3 o = q.oEta.xyz;
  vec3 n = q.nIndex.xyz;
  if (repeats == 0) {
    BsdfValues v = valuesOf(i, o, n, surface);
    answers[row].first = vec4(v.d, v.g, v.gCorrelated, v.fresnel);
    answers[row].second = vec4(v.transmitted, v.f, v.fCos, v.fCorrelated);
    answers[row].third = vec4(v.pdfD, v.pdfVisible, 0.0, 0.0);
    return;
  }
  surface.transmits = transmits;
  surface.distribution = distribution;
  float sum = 0.0;
  for (int r = 0; r < repeats; ++r) {
    // Every turn has a direction of its own, so that nothing can be carried over from the last one.
    vec3 turned = o + vec3(1e-4, 2e-4, 0.0) * float(r);
    if (way == 3) sum += turned.x + turned.y;
    else sum += valuesOf(i, turned, n, surface).f;
  }
  answers[row].first = vec4(sum);
}
