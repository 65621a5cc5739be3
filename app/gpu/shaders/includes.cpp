#include "gpu/shaders/includes.h"

#include "core/error.h"
#include "core/files.h"

namespace gg::gpu::shaders {
namespace fs = std::filesystem;

std::string display_name(const fs::path& file) {
  const fs::path relative = file.lexically_relative(home_directory() / "shaders");
  return relative.empty() || relative.begin()->string() == ".." ? file.string() : relative.string();
}

Includes::Includes(const std::string& name, const fs::path& root) {
  const fs::path file = fs::weakly_canonical(root);
  paths_[name] = file;
  seen_.insert(file);
}

Includes::IncludeResult* Includes::includeLocal(const char* header, const char* includer,
                                                std::size_t) {
  std::error_code ignored;
  fs::path file = home_directory() / "shaders" / header;
  if (!fs::is_regular_file(file, ignored)) {
    const auto from = paths_.find(includer);
    if (from != paths_.end()) file = from->second.parent_path() / header;
  }
  // An unnamed result is an error whose text is the data.
  if (!fs::is_regular_file(file, ignored))
    return &files_.emplace_back("", "no such file in shaders/ nor beside the including file")
                .result;
  file = fs::weakly_canonical(file);
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
