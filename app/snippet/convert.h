// Snippets in the shading languages that SPIRV-Cross writes.
#pragma once

#include <string>

namespace gg::snippet {

enum class Foreign { hlsl, msl };

// The text's functions and structs (GLSL 4.50, flattened) in another language: HLSL for shader model 5.0, Metal 2.1. Constants are
// folded into what uses them; functions that the GLSL only declares are declared. A combined sampler becomes a texture and a
// sampler. Throws Error(internal) with the compiler's log.
std::string converted(const std::string& glsl, Foreign language);

// What one function costs: SPIR-V instructions of its optimised, inlined body, as a line for people. Throws as converted().
struct Cost {
  int arithmetic = 0, roots = 0, trigonometric = 0, reads = 0, branches = 0;
};
Cost cost(const std::string& glsl, const std::string& function);

} // namespace gg::snippet
