// That this compiles is the test: every pure snippet by itself, as C++ in double precision.
#include "glsl/f64.h"

// What an engine supplies is declared and never defined here (refraction/engine.glsl).
#pragma GCC diagnostic ignored "-Wunused-function"

namespace {
using Real = double;
#define BSDF_DOUBLE
#include "glsl/shim.inl"
#include "glsl_generated/f64_alone.inl"
} // namespace
