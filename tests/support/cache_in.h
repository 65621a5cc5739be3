// The cache directory somewhere else, for tests of what is kept there.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

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

// What is kept in a folder of the cache that `directory` holds.
inline std::vector<std::filesystem::path> kept_files(const std::filesystem::path& directory,
                                                     const char* folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory / "groundglass" / folder))
    files.push_back(entry.path());
  return files;
}

} // namespace gg::test
