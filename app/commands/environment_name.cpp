#include "commands/environment_name.h"

#include "core/error.h"
#include "core/files.h"
#include "core/suggest.h"
#include "environment/map.h"

#include <fmt/format.h>

#include <algorithm>

namespace gg::commands {
namespace {

namespace fs = std::filesystem;

fs::path shipped() {
  return home_directory() / "assets/environments";
}

// "studio_small_03_1k" without "_1k": how wide the map is.
std::string without_resolution(const std::string& stem) {
  const std::size_t at = stem.rfind('_');
  const bool is_resolution = at != std::string::npos && stem.ends_with('k')
                             && stem.find_first_not_of("0123456789", at + 1) == stem.size() - 1;
  return is_resolution ? stem.substr(0, at) : stem;
}

} // namespace

std::vector<std::string> environment_names() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(shipped(), none))
    if (const fs::path& file = entry.path(); environment::is_map_file(file))
      names.push_back(without_resolution(file.stem().string()));
  std::ranges::sort(names);
  return names;
}

fs::path find_environment(const std::string& text) {
  std::error_code none;
  if (fs::exists(text, none)) return text;
  for (const auto& entry : fs::directory_iterator(shipped(), none)) {
    const std::string stem = entry.path().stem().string();
    if (text == stem || text == without_resolution(stem)) return entry.path();
  }
  const std::vector<std::string> names = environment_names();
  throw Error(ExitCode::input, text, "is neither a file nor the name of an environment",
              fmt::format("{}Give a .hdr or .exr file; a name: {}; a colour R,G,B; or none.",
                          did_you_mean(text, names), fmt::join(names, ", ")));
}

} // namespace gg::commands
