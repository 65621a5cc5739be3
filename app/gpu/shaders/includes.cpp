#include "gpu/shaders/includes.h"

#include "core/error.h"
#include "core/files.h"

namespace gg::gpu::shaders {
namespace fs = std::filesystem;

std::string display_name(const fs::path& file) {
  const fs::path relative = file.lexically_relative(home_directory() / "shaders");
  return relative.empty() || relative.begin()->string() == ".." ? file.string() : relative.string();
}

std::optional<fs::path> find_include(const std::string& header, const fs::path& from) {
  std::error_code ignored;
  for (const fs::path& file : {home_directory() / "shaders" / header, from.parent_path() / header})
    if (fs::is_regular_file(file, ignored)) return fs::weakly_canonical(file);
  return std::nullopt;
}

Includes::Includes(const std::string& name, const fs::path& root) {
  const fs::path file = fs::weakly_canonical(root);
  paths_[name] = file;
  seen_.insert(file);
}

Includes::IncludeResult* Includes::includeLocal(const char* header, const char* includer,
                                                std::size_t) {
  const auto from = paths_.find(includer);
  const auto found = find_include(header, from != paths_.end() ? from->second : fs::path());
  // An unnamed result is an error whose text is the data.
  if (!found)
    return &files_.emplace_back("", "no such file in shaders/ nor beside the including file")
                .result;
  const fs::path& file = *found;
  const std::string name = display_name(file);
  paths_[name] = file;
  const bool first = seen_.insert(file).second;
  try {
    return &files_.emplace_back(name, first ? read_text(file) : std::string{}).result;
  } catch (const Error& error) {
    return &files_.emplace_back("", error.what()).result;
  }
}

Includes::IncludeResult* Includes::includeSystem(const char* header, const char* includer,
                                                 std::size_t depth) {
  return includeLocal(header, includer, depth);
}

} // namespace gg::gpu::shaders
