// Files that are read again when they change on disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gg::viewer {

class WatchedFiles {
public:
  // Instead of those before.
  void watch(const std::vector<std::string>& paths);
  // One that has changed since the last call; empty if none has. A file that is gone, or is being written, has not.
  std::string changed();

private:
  struct File {
    std::string path;
    std::filesystem::file_time_type time;
  };
  std::vector<File> files_;
};

} // namespace gg::viewer
