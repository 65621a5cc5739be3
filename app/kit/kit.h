// Folders with which rough refraction runs in other people's programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gg::kit {

enum class Target { three, webgl2, opengl, vulkan };

std::vector<std::string> target_names();
std::optional<Target> target_named(const std::string& name);

// Writes the folder: the target's own files from assets/kit, the flattened shaders, the tables as half floats with a description of
// their axes, and, but for three.js, a scene and an environment to draw. `directory` is made if it is not there; files of the
// same name are replaced. Throws Error(output).
void write(Target target, const std::filesystem::path& home,
           const std::filesystem::path& directory);

} // namespace gg::kit
