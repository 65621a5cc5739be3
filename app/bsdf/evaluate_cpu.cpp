#include "bsdf/evaluate.h"
#include "glsl/f64.h"

#include <tbb/parallel_for.h>

namespace gg::bsdf {
namespace {

using namespace glsl;

f64::vec3 vector(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

f64::BsdfSurface surface(const Query& q) {
  return {
      q.lobe == Lobe::transmission, static_cast<int>(q.distribution), q.alpha, q.eta, q.cn, q.ck};
}

Values<double> answer(const Query& q) {
  const f64::BsdfSurface s = surface(q);
  // Walter knows i where the snippets know wo. The compensated form normalises: in double, before
  // it, half an ulp of rounding would be amplified as input noise is.
  const f64::BsdfValues v =
      f64::bsdfValues(f64::bsdfFacetCompensated(vector(q.o), vector(q.i), vector(q.n), s), s);
  return {v.d, v.g,    v.gCorrelated, v.fresnel, v.transmitted,
          v.f, v.fCos, v.fCorrelated, v.pdfD,    v.pdfVisible};
}

} // namespace

void evaluate_cpu(std::span<const Query> queries, std::span<Values<double>> values) {
  constexpr std::size_t grain = 1024; // some 200 us of work: enough to make up for handing it out
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, queries.size(), grain),
                    [&](const auto& range) {
                      for (std::size_t q = range.begin(); q != range.end(); ++q)
                        values[q] = answer(queries[q]);
                    });
}

} // namespace gg::bsdf
