#include "core/cache_directory.h"

#include <cstdlib>

namespace gg {

std::optional<std::filesystem::path> cache_directory() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && cache[0] == '/')
    return std::filesystem::path(cache) / "groundglass";
  if (const char* home = std::getenv("HOME"); home && home[0] == '/')
    return std::filesystem::path(home) / ".cache" / "groundglass";
  return std::nullopt;
}

} // namespace gg
