// Snippets in WGSL: cut from shaders/wgsl/snippets.wgsl, which naga made of all of them (shaders/wgsl/make).
#pragma once

#include <filesystem>
#include <string>

namespace gg::snippet {

// What `glsl`, flattened, declares, and what that needs, in WGSL. Throws Error(input) if the file lacks one of its functions.
std::string wgsl_of(const std::filesystem::path& shaders, const std::string& glsl);

} // namespace gg::snippet
