#version 450
// Answers a batch of queries: `groundglass eval` on the device.
#include "bsdf/values.glsl"
#include "interface/queries.glsl"

layout(local_size_x = 64) in;

// The half-vector as the frame computes it, or with the rounding of its sums carried along.
layout(constant_id = 0) const bool compensated = true;

layout(std430, set = 0, binding = 0) readonly buffer Queries { PackedQuery queries[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { PackedValues answers[]; };

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
  // Walter knows i where the snippets know wo.
  vec3 wo = q.iAlpha.xyz;
  vec3 wi = q.oEta.xyz;
  vec3 n = q.nIndex.xyz;
  Facet facet = compensated ? bsdfFacetCompensated(wi, wo, n, surface) : bsdfFacet(wi, wo, n, surface);
  BsdfValues v = bsdfValues(facet, surface);
  answers[row].first = vec4(v.d, v.g, v.gCorrelated, v.fresnel);
  answers[row].second = vec4(v.transmitted, v.f, v.fCos, v.fCorrelated);
  answers[row].third = vec4(v.pdfD, v.pdfVisible, 0.0, 0.0);
}
