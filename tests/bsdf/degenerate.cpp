// Input at and beyond the edge of what makes sense: always a defined number, in both precisions.
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <gtest/gtest.h>

#include <vector>

namespace single_precision {
using namespace gg::glsl::f32;
#define GG_SUITE degenerate_in_float
#include "bsdf/degenerate.inl"
#undef GG_SUITE
} // namespace single_precision

namespace double_precision {
using namespace gg::glsl::f64;
#define GG_SUITE degenerate_in_double
#include "bsdf/degenerate.inl"
#undef GG_SUITE
} // namespace double_precision
