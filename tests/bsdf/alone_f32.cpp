// That this compiles is the test: every pure snippet by itself, as C++ in single precision and
// nothing but.
#include "glsl/f32.h"

// What an engine supplies is declared and never defined here (refraction/engine.glsl).
#pragma GCC diagnostic ignored "-Wunused-function"

namespace {
using Real = float;
#include "glsl/shim.inl"
#include "glsl_generated/f32_alone.inl"
} // namespace
