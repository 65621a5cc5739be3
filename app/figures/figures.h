// The figures of Marschner's lecture on microfacet models, redrawn from the snippets of
// shaders/bsdf.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gg::figures {

// Writes every figure as SVG and PNG into the directory, which is made if it does not exist;
// returns the files' names. Throws Error(output).
std::vector<std::string> write_all(const std::filesystem::path& directory);

} // namespace gg::figures
