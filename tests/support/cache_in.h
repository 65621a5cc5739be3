// The cache directory somewhere else, for tests of what is kept there.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace gg::test {

// For as long as it lives.
class CacheIn {
public:
  explicit CacheIn(const std::filesystem::path& directory) {
    if (const char* before = std::getenv("XDG_CACHE_HOME")) before_ = before;
    ::setenv("XDG_CACHE_HOME", directory.c_str(), 1);
  }
  ~CacheIn() {
    if (before_.empty())
      ::unsetenv("XDG_CACHE_HOME");
    else
      ::setenv("XDG_CACHE_HOME", before_.c_str(), 1);
  }
  CacheIn(const CacheIn&) = delete;
  CacheIn& operator=(const CacheIn&) = delete;

private:
  std::string before_;
};

inline std::filesystem::path empty_directory(const char* name) {
  const std::filesystem::path directory = std::filesystem::path(GROUNDGLASS_OUTPUT_DIR) / name;
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  return directory;
}

} // namespace gg::test
