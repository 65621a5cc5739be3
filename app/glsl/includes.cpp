#include "glsl/includes.h"

#include "core/files.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace gg::glsl {
namespace fs = std::filesystem;
namespace {

// What an `#include "name"` line names, empty if that is nothing; no value for any other line.
std::optional<std::string> included(std::string_view line) {
  constexpr std::string_view blanks = " \t", word = "include";
  const auto skip = [&](std::size_t from) {
    return std::min(line.find_first_not_of(blanks, from), line.size());
  };
  const std::size_t hash = skip(0);
  if (!line.substr(hash).starts_with('#')) return std::nullopt;
  const std::size_t start = skip(hash + 1);
  if (!line.substr(start).starts_with(word)) return std::nullopt;
  const std::size_t open = line.find('"', start);
  if (open == std::string_view::npos) return "";
  const std::size_t close = line.find('"', open + 1);
  if (close == std::string_view::npos) return "";
  return std::string(line.substr(open + 1, close - open - 1));
}

} // namespace

bool IncludeWalk::is_open(const fs::path& file) const {
  return std::ranges::find(open_, file) != open_.end();
}

void IncludeWalk::walk(const fs::path& file) {
  if (std::ranges::find(files_, file) != files_.end()) return;
  files_.push_back(file);
  open_.push_back(file);
  std::istringstream lines(read_text(path_of(file)));
  Place at{file, 0};
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    ++at.line;
    const std::optional<std::string> name = included(line);
    const fs::path wanted = name ? find(*name, at) : fs::path();
    if (wanted.empty())
      text(line, at);
    else
      walk(wanted);
  }
  open_.pop_back();
}

} // namespace gg::glsl
