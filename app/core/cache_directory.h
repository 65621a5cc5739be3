// Where the program keeps between runs what it could make again.
#pragma once

#include <filesystem>
#include <optional>

namespace gg {

// $XDG_CACHE_HOME/groundglass or ~/.cache/groundglass, which need not exist. Nothing if neither variable holds an absolute path:
// relative ones are to be ignored, says the XDG base directory specification.
std::optional<std::filesystem::path> cache_directory();

} // namespace gg
