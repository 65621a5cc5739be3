#include "viewer/watched_files.h"

#include <chrono>

namespace gg::viewer {
namespace {

// Editors write in several steps: what changed within this time may not be complete.
constexpr auto settled = std::chrono::milliseconds(300);

} // namespace

void WatchedFiles::watch(const std::vector<std::string>& paths) {
  files_.clear();
  for (const std::string& path : paths) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(path, error);
    if (!error) files_.push_back({path, time});
  }
}

std::string WatchedFiles::changed() {
  for (File& file : files_) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file.path, error);
    if (error || time == file.time) continue;
    if (std::filesystem::file_time_type::clock::now() - time < settled) continue;
    file.time = time;
    return file.path;
  }
  return {};
}

} // namespace gg::viewer
