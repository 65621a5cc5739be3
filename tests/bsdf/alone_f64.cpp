// That this compiles is the test: every pure snippet by itself, as C++ in double precision.
#include "glsl/f64.h"

namespace {
using Real = double;
#define BSDF_DOUBLE
#include "glsl/shim.inl"
#include "glsl_generated/f64_alone.inl"
} // namespace
