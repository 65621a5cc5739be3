// Every pure snippet of shaders/ in single precision, honestly: gg::glsl::f32::ggxD(...) is the
// text of shaders/bsdf/ggx.glsl.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <type_traits>

namespace gg::glsl::f32 {
using Real = float;
#include "glsl/shim.inl"
#include "glsl_generated/f32.inl"
} // namespace gg::glsl::f32
