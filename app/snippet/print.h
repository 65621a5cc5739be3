// `groundglass snippet`: snippets as text for people's own programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gg::snippet {

enum class Target { glsl, vulkan, essl, hlsl, msl, wgsl, cpp };

std::optional<Target> target_named(const std::string& name);

struct PrintOptions {
  Target target = Target::glsl;
  std::string prefix; // before every name
  bool strip = false; // no comments, no empty lines
};

// The snippets of those names (see catalog.h) with all that they include, each once, as text that the target's compiler takes as
// it is. Throws Error(usage) for a name that does not exist and a prefix that is no identifier, Error(unsupported) where a
// snippet reads textures and the target has no combined samplers to pass (cpp, wgsl).
std::string print(const std::filesystem::path& shaders, const std::vector<std::string>& names,
                  const PrintOptions& options);

std::string list(const std::filesystem::path& shaders);

// Signatures, what they return, units and ranges, cost, limits and sources: of a file, or of one function of it.
std::string explain(const std::filesystem::path& shaders, const std::string& name);

} // namespace gg::snippet
