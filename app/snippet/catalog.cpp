#include "snippet/catalog.h"

#include "core/error.h"
#include "core/files.h"
#include "core/suggest.h"
#include "glsl/flatten.h"
#include "snippet/scan.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

namespace gg::snippet {
namespace fs = std::filesystem;
namespace {

Snippet read(const fs::path& shaders, const fs::path& file) {
  Snippet snippet{.file = file, .name = file.stem().string(), .fetches = glsl::is_fetch(file)};
  const std::pair<std::string_view, std::string*> fields[] = {{"Frame    ", &snippet.frame},
                                                              {"alpha    ", &snippet.alpha},
                                                              {"Returns  ", &snippet.returns},
                                                              {"Source   ", &snippet.source},
                                                              {"Limits   ", &snippet.limits}};
  std::string* into = &snippet.summary;
  std::istringstream lines(read_text(shaders / file));
  for (std::string line; std::getline(lines, line) && line.starts_with("//");) {
    std::string_view rest = std::string_view(line).substr(std::min<std::size_t>(3, line.size()));
    for (const auto& [word, field] : fields)
      if (rest.starts_with(word)) {
        into = field;
        rest.remove_prefix(word.size());
      }
    if (into == &snippet.summary && into->empty() && rest.find(": ") != std::string_view::npos)
      rest.remove_prefix(rest.find(": ") + 2);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    *into += (into->empty() ? "" : " ") + std::string(rest);
  }
  return snippet;
}

} // namespace

std::vector<Snippet> catalog(const fs::path& shaders) {
  std::vector<Snippet> all;
  for (const char* folder : {"bsdf", "color", "environment", "neighbours", "refraction"})
    for (const fs::path& file : glsl::list_snippets(shaders, folder))
      all.push_back(read(shaders, file));
  return all;
}

const Snippet& find(const std::vector<Snippet>& snippets, const fs::path& shaders,
                    const std::string& name) {
  for (const Snippet& one : snippets)
    if (name == one.name || name == one.file || name + ".glsl" == one.file) return one;
  std::vector<std::string>
      names; // files before what they declare: of names as near, the first is meant
  for (const Snippet& one : snippets)
    names.push_back(one.name);
  for (const Snippet& one : snippets)
    for (const Item& item : items(read_text(shaders / one.file))) {
      if (item.name == name) return one;
      names.push_back(item.name);
    }
  throw Error(ExitCode::usage, name, "is no snippet, and nothing that one declares",
              did_you_mean(name, names) + "See groundglass snippet --list.");
}

} // namespace gg::snippet
