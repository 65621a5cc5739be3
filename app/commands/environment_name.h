// The environments that ship with the program, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gg::commands {

// "studio_small_03" for assets/environments/studio_small_03_1k.hdr; sorted.
std::vector<std::string> environment_names();

// The file that --env names: the path itself if there is such a file, else the environment of that
// name, with or without its resolution. Throws Error(input) if there is neither.
std::filesystem::path find_environment(const std::string& text);

} // namespace gg::commands
