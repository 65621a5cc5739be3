#include "snippet/wgsl.h"

#include "core/error.h"
#include "core/files.h"
#include "snippet/scan.h"

#include <map>
#include <set>
#include <vector>

namespace gg::snippet {

std::string wgsl_of(const std::filesystem::path& shaders, const std::string& glsl) {
  const std::filesystem::path path = shaders / "wgsl" / "snippets.wgsl";
  const std::string all = read_text(path);
  const std::vector<Token> words = tokens(all);
  const std::vector<Item> declared = items(all);
  std::map<std::string, std::size_t> at;
  for (std::size_t i = 0; i < declared.size(); ++i)
    at[declared[i].name] = i;

  std::set<std::size_t> wanted;
  std::vector<std::size_t> open;
  std::set<std::string> supplied;
  const auto want = [&](const std::string& name) {
    const auto found = at.find(name);
    if (found == at.end()) return false;
    if (wanted.insert(found->second).second) open.push_back(found->second);
    return true;
  };
  for (const Item& item : items(glsl)) {
    if (item.kind == Item::Kind::prototype) supplied.insert(item.name);
    if (item.kind == Item::Kind::function && !want(item.name))
      throw Error(ExitCode::input, path, "has no " + item.name,
                  "Make it again: shaders/wgsl/make.");
  }
  while (!open.empty()) {
    const Item& item = declared[open.back()];
    open.pop_back();
    for (const Token& word : words)
      if (word.begin > item.begin && word.end < item.end && is_word(all, word)) {
        const std::string name = all.substr(word.begin, word.end - word.begin);
        if (!supplied.contains(name)) want(name);
      }
  }
  std::string out;
  for (const std::string& name : supplied)
    if (const auto found = at.find(name); found != at.end()) {
      const std::size_t begin = declared[found->second].begin;
      out += "// Yours to supply: " + all.substr(begin, all.find(" {", begin) - begin) + "\n";
    }
  for (const std::size_t i : wanted)
    out += all.substr(declared[i].begin, declared[i].end - declared[i].begin) + "\n\n";
  return out;
}

} // namespace gg::snippet
